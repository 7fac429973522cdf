# Perceptron -- sections: points (p1, p2, label), lines (p1, p2, mistakes), mistakes (bound,
# mistakes)
set terminal svg size 720,340 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "lines" using 3 name "LINE" nooutput
last = int(LINE_max)
shade(k) = int(225 - 115.0*k/last) * 0x010101 # later lines are darker
set multiplot
set label 1 "(a)" at screen 0.015,0.95 font ",12"
set label 2 "(b)" at screen 0.52,0.95 font ",12"
set bmargin at screen 0.15
set tmargin at screen 0.94

set lmargin at screen 0.085
set rmargin at screen 0.46
set xrange [-17:17]
set yrange [-17:17]
set xtics 8
set ytics 8
set xlabel "p_1" offset 0,0.4
set ylabel "p_2" offset 1.5,0
set clip two
plot data index "lines" using 1:2:(shade($3)) with lines lw 1.2 lc rgb variable, \
     data index "lines" using ($3 == last ? $1 : NaN):2 with lines lw 2.4 lc rgb "black", \
     data index "points" using ($3 > 0 ? $1 : NaN):2 with points pt 7 ps 0.6 lc rgb BLUE, \
     data index "points" using ($3 < 0 ? $1 : NaN):2 with points pt 4 ps 0.7 lw 1.4 lc rgb RED

unset label
set lmargin at screen 0.62
set rmargin at screen 0.975
set logscale xy
set xrange [5:50000]
set yrange [0.7:50000]
set xtics 10
set ytics 10
unset mxtics
unset mytics
set xlabel "bound"
set ylabel "mistakes" offset 1,0
plot x with lines lw 1.2 lc rgb GREY, \
     data index "mistakes" using 1:2 with points pt 7 ps 0.35 lc rgb BLUE
unset multiplot
