# Pieces of a ReLU net -- section: sawtooth (x, y, layers)
set terminal svg size 720,240 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,3
set xrange [0:1]
set yrange [0:1]
set xtics 0.25
set ytics 1
set xlabel "x"
do for [q=1:3] {
    set title sprintf("%d hidden layer%s", q, q == 1 ? "" : "s") offset 0,-0.3
    plot data index "sawtooth" using ($3 == q ? $1 : NaN):2 with lines lw 2 lc rgb BLUE
}
unset multiplot
