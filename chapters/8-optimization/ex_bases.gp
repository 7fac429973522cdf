# Two bases -- sections: conditions (cells, hats, units), descents (x, function, hats, few, many)
set mxtics 1
set mytics 1
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.89 spacing 0.09
set title "(a) condition numbers"
set xlabel "cells" offset 0,0.4
set logscale xy
set xrange [0.85:38]
set yrange [1:1e8]
set xtics (1, 2, 4, 8, 16, 32)
set ytics 1,100 format "10^{%T}"
set key top left Left reverse samplen 2.5
plot data index "conditions" using 1:3 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "ReLU units", \
     data index "conditions" using 1:2 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.55 title "B-splines"
unset logscale
set title "(b) gradient descent in either basis"
set xlabel "x" offset 0,0.4
set xrange [0:1]
set yrange [-1.15:1.75]
set xtics 0.25
set ytics 0.5 format "%g"
set key top right samplen 3
plot data index "descents" using 1:2 with lines lw 5 lc rgb LIGHT title "the function", \
     data index "descents" using 1:3 with linespoints lw 1.6 lc rgb BLUE pt 7 ps 0.55 title "B-splines, 20 steps", \
     data index "descents" using 1:5 with linespoints lw 1.6 dt 2 lc rgb RED pt 4 ps 0.7 title "ReLU units, 2000 steps", \
     data index "descents" using 1:4 with linespoints lw 1.6 dt 3 lc rgb GOLD pt 8 ps 0.7 title "ReLU units, 20 steps"
unset multiplot
