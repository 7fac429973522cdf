# Curve properties -- sections: triangles, curve (x, y, span), polygon (x, y)
set terminal svg size 720,270 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,2
set size ratio -1
set xrange [-0.3:6.9]
set yrange [-0.4:3]
set xlabel "s_1"
set ylabel "s_2"
set xtics 2
set ytics 1
array TINT[5] = ["#bfdcee", "#f6d5bd", "#bde6da", "#f1dbe8", "#f8e6bd"]
array SPANS[2] = [1, 2]
do for [p=1:2] {
    a = SPANS[p]
    set title sprintf("hull of c_%d … c_%d", a, a + 3)
    plot data index "triangles" using ($3==a?$1:NaN):2 with filledcurves closed fs solid noborder lc rgb TINT[a+1], \
         data index "polygon" using 1:2 with linespoints ls 7 dt 2 pt 7 ps 0.6, \
         data index "curve" using 1:2 with lines lw 1.5 lc rgb GREY, \
         data index "curve" using ($3==a?$1:NaN):2 with lines lw 3.5 lc rgb COLOR[a+1]
}
unset multiplot
