# How cost grows on this machine; make bench draws it to build/ex_bench.svg.
set terminal svg size 760,560 font "DejaVu Sans,11" background rgb "white"
set multiplot layout 2,2 margins 0.09,0.97,0.09,0.94 spacing 0.11,0.14
set yrange [0:*]
set ylabel "ns" offset 1
set key top left Left reverse width -2
set offsets 0,0,graph 0.3,0 # room for the key
set format x "10^{%L}"
set mxtics 1
set logscale x
set xrange [1e3:1e7]
set title "points (degree 3, 100 spans)"
plot data index "points" using 1:2 with linespoints ls 1 title "basis functions", \
     data index "points" using 1:3 with linespoints ls 2 dt 2 title "curve in R^3"
set xrange [10:1e6]
set title "spans (degree 3)"
plot data index "spans" using 1:2 with linespoints ls 1, \
     data index "spans" using 1:3 with linespoints ls 2 dt 2
unset logscale x
set xrange [*:*]
set format x "%g"
set title "degree (100 spans)"
plot data index "degree" using 1:2 with linespoints ls 1, \
     data index "degree" using 1:3 with linespoints ls 2 dt 2
set title "levels (degree 2, two directions)"
set xtics 2
set logscale y
set yrange [10:1e5]
set format y "10^{%L}"
set offsets
plot data index "levels" using 1:2 with linespoints ls 3 title "to build, a function", \
     data index "levels" using 1:4 with linespoints ls 1 title "THB-splines at a point", \
     data index "levels" using 1:3 with linespoints ls 2 dt 2 title "surface point"
unset multiplot
