# Spectral convolution -- sections: edges (x, y), slow wave, wave, fast wave (x, y, value),
# responses (frequency, ideal, polynomial), from one node (node, ideal, polynomial)
set terminal svg size 720,520 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
unset border
unset tics
set size ratio -1
set xrange [-0.06:1.06]
set yrange [-0.06:1.06]
area(v) = 3.6 * sqrt(abs(v))
array NAME[3] = ["slow wave", "wave", "fast wave"]
array TITLE[3] = ["(a) frequency no. 2 of 40", "(b) no. 5", "(c) no. 40, the highest"]
do for [p=1:3] {
    set lmargin at screen 0.01 + 0.33 * (p - 1)
    set rmargin at screen 0.32 + 0.33 * (p - 1)
    set bmargin at screen 0.50
    set tmargin at screen 0.94
    set title TITLE[p]
    plot data index "edges" using 1:2 with lines lw 1 lc rgb LIGHT, \
         data index NAME[p] using ($3 > 0 ? $1 : NaN):2:(area($3)) with points pt 7 ps variable lc rgb BLUE, \
         data index NAME[p] using ($3 > 0 ? NaN : $1):2:(area($3)) with points pt 7 ps variable lc rgb "white", \
         data index NAME[p] using ($3 > 0 ? NaN : $1):2:(area($3)) with points pt 6 lw 1.6 ps variable lc rgb RED
}
set border 3
set tics out scale 0.6
set size noratio
set bmargin at screen 0.10
set tmargin at screen 0.40
set key top right Left reverse
set lmargin at screen 0.08
set rmargin at screen 0.46
set title "(d) what the filters do to a frequency"
set xlabel "frequency" offset 0,0.4
set xrange [0:2]
set yrange [-0.15:1.25]
set xtics nomirror 0.5
set ytics nomirror 0.5
plot data index "responses" using 1:2 with lines lw 1.6 lc rgb RED title "ideal", \
     data index "responses" using 1:3 with lines lw 2.4 lc rgb BLUE dt 1 title "degree 5"
set lmargin at screen 0.56
set rmargin at screen 0.98
set title "(e) what they make of a one at node 0 of a circle"
set xlabel "place on the circle" offset 0,0.4
set xrange [-34:34]
set yrange [-0.15:0.6]
set xtics nomirror 11
set ytics nomirror 0.2
plot data index "from one node" using 1:2 with impulses lw 1.2 lc rgb RED notitle, \
     data index "from one node" using 1:2 with points pt 6 ps 0.55 lw 1.2 lc rgb RED title "ideal", \
     data index "from one node" using 1:3 with points pt 7 ps 0.4 lc rgb BLUE title "degree 5"
unset multiplot
