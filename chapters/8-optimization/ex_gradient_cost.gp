# The cost of a gradient -- sections: widths (parameters, value, gradient, differences), depths
# (L, edges, paths)
set mxtics 1
set mytics 1
set multiplot layout 1,2 margins 0.10,0.985,0.15,0.90 spacing 0.13
set title "(a) two hidden layers, ever wider"
set xlabel "parameters" offset 0,0.4
set ylabel "multiply-adds" offset 0.5,0
set logscale xy
set xrange [3:3e6]
set yrange [1:1e14]
set xtics 10,100 format "10^{%T}"
set ytics 1,1e3 format "10^{%T}"
set key top left Left reverse samplen 2.5
plot data index "widths" using 1:4 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "gradient by differences", \
     data index "widths" using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.55 title "gradient by backpropagation", \
     data index "widths" using 1:2 with linespoints lw 1.2 lc rgb GREY pt 6 ps 0.55 title "value"
set title "(b) four units a layer, ever deeper"
set xlabel "L" offset 0,0.4
set ylabel "number" offset 1.5,0
unset logscale x
set xrange [0.5:10.5]
set yrange [5:2e7]
set xtics 1 format "%g"
set ytics 10,100
plot data index "depths" using 1:3 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "paths", \
     data index "depths" using 1:2 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.55 title "edges"
unset multiplot
