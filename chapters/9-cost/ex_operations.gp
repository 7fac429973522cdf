# Operations of a point -- section: degrees (d, definition, triangle, sum, deboor, surface, grid)
set mxtics 1
set multiplot layout 1,2 margins 0.10,0.985,0.15,0.90 spacing 0.13
set xlabel "degree" offset 0,0.4
set ylabel "operations" offset 0.5,0
set logscale y
set xrange [0.7:7.3]
set xtics 1
set ytics 10 format "10^{%T}"
set yrange [1:1e5]
set key top left Left reverse samplen 2.5
set title "(a) the d + 1 functions at a point"
plot data index "degrees" using 1:2 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "Definition 3 word by word", \
     data index "degrees" using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.6 title "all together"
set title "(b) a point in space"
plot data index "degrees" using 1:6 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "surface", \
     data index "degrees" using 1:5 with linespoints lw 1.8 dt 4 lc rgb GREEN pt 9 ps 0.7 title "curve, de Boor's algorithm", \
     data index "degrees" using 1:4 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.6 title "curve, basis and sum", \
     data index "degrees" using 1:7 with linespoints lw 1.8 lc rgb GREY pt 6 ps 0.7 title "surface on a grid"
unset multiplot
