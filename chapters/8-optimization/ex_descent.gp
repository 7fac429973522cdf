# Descent -- sections: valley, hills (w, b, loss) and for either a section a method
# (step, w, b, loss, distance); valley's minimum, worse minimum, better minimum (w, b)
set terminal svg size 720,700 font "DejaVu Sans,11" background rgb "white"
set output image
array METHOD[3] = ["descent", "momentum", "Adam"]
array MARK[3] = [7, 4, 8]
array DASH[3] = [1, 2, 3]

# level lines, as tables
set contour base
unset surface
set cntrparam linear
set cntrparam levels discrete 0.2, 0.5, 1, 2, 4, 8, 16, 32, 64
set table $VALLEY
splot data index "valley" using 1:2:3
set cntrparam levels discrete 0.075, 0.085, 0.1, 0.115, 0.13, 0.2, 0.5, 1, 1.5, 2
set table $HILLS
splot data index "hills" using 1:2:3
unset table
unset contour

set multiplot
set xrange [-3:2]
set yrange [-1.5:3.5]
set xtics 1
set ytics 1
set xlabel "w" offset 0,0.6
set ylabel "b" offset 0.8,0
set bmargin at screen 0.42
set tmargin at screen 0.95
set lmargin at screen 0.08
set rmargin at screen 0.485
set title "(a) w p + b: a valley"
set key at graph 0.98,0.98 top right samplen 2.5 opaque
plot $VALLEY using 1:2 with lines lw 0.8 lc rgb LIGHT, \
     for [m=1:3] data index "valley, ".METHOD[m] using 2:3 every ::0::120 with linespoints lw 1.3 dt DASH[m] pt MARK[m] ps 0.5 lc rgb COLOR[m] title METHOD[m], \
     data index "valley's minimum" using 1:2 with points pt 2 ps 1.2 lw 2.5 lc rgb "black" notitle
unset key
unset ylabel
set lmargin at screen 0.555
set rmargin at screen 0.975
set title "(b) tanh(w p + b): hills"
set style textbox opaque noborder margins 0.3,0.3
set label 1 "better" at -1.98,2.55 center front boxed
set label 2 "worse" at 0.08,-0.35 left front boxed
plot $HILLS using 1:2 with lines lw 0.8 lc rgb LIGHT, \
     for [m=1:3] data index "hills, ".METHOD[m] using 2:3 with linespoints lw 1.3 dt DASH[m] pt MARK[m] ps 0.5 pi 8 lc rgb COLOR[m], \
     data index "better minimum" using 1:2 with points pt 2 ps 1.2 lw 2.5 lc rgb "black", \
     data index "worse minimum" using 1:2 with points pt 2 ps 1.2 lw 2.5 lc rgb "black"
unset label

set bmargin at screen 0.07
set tmargin at screen 0.295
set lmargin at screen 0.08
set rmargin at screen 0.485
set xrange [0:400]
set xtics 100
set xlabel "step"
set logscale y
set title "(c) distance from the minimum of (a)"
set yrange [1e-12:10]
set ytics 1e-12,1e3 format "10^{%T}"
set mytics 1
plot for [m=1:3] data index "valley, ".METHOD[m] using 1:5 with lines lw 1.8 dt DASH[m] lc rgb COLOR[m]
set lmargin at screen 0.555
set rmargin at screen 0.975
set title "(d) loss on the way through (b)"
set yrange [0.05:3]
set ytics (0.1, 1) format "%g"
plot for [m=1:3] data index "hills, ".METHOD[m] using 1:4 with lines lw 1.8 dt DASH[m] lc rgb COLOR[m]
unset multiplot
