# Graph signal -- sections: cells (x, y, box, clean, noisy, graph, mlp), errors (pairs, then mean,
# least and most of graph and mlp, noise)
set terminal svg size 720,400 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
unset colorbox
unset border
unset tics
set size ratio -1
set xrange [-0.02:1.02]
set yrange [-0.02:1.02]
set cbrange [-2:2]
set palette defined (0 "#08306b", 0.5 "#6baed6", 1 "#ffffff")
set style fill solid border lc rgb "#404040"
array COLUMN[4] = [7, 8, 9, 10]
array TITLE[4] = ["(a) the signal", "(b) with noise", "(c) graph network", "(d) MLP"]
do for [p=1:4] {
    left = 0.01 + 0.27 * ((p - 1) % 2)
    top = p <= 2 ? 0.93 : 0.44
    set lmargin at screen left
    set rmargin at screen left + 0.22
    set tmargin at screen top
    set bmargin at screen top - 0.40
    set title TITLE[p] offset 0,-0.6
    plot data index "cells" using 1:2:3:4:5:6:COLUMN[p] with boxxyerror lw 0.5 lc palette
}
set border 3
set lmargin at screen 0.64
set rmargin at screen 0.98
set tmargin at screen 0.93
set bmargin at screen 0.13
set size noratio
set title "(e) error on new pairs" offset 0,-0.6
set xlabel "pairs for the steps" offset 0,0.3
set ylabel "mean squared error" offset 1,0
set logscale x 2
set xrange [12:1400]
set yrange [0:0.37]
set xtics nomirror out scale 0.6 (16, 64, 256, 1024)
set ytics nomirror out scale 0.6 0.1
set key top right Left reverse
plot data index "errors" using 1:8 with lines lw 1.2 dt 2 lc rgb GREY title "noise", \
     data index "errors" using 1:5:6:7 with yerrorlines lw 1.8 lc rgb RED pt 5 ps 0.6 title "MLP", \
     data index "errors" using 1:2:3:4 with yerrorlines lw 1.8 lc rgb BLUE pt 7 ps 0.6 title "graph network"
unset multiplot
