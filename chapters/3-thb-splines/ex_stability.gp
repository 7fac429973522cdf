# Stability -- sections: degree 2, degree 3 (levels, hb, thb)
set multiplot layout 1,2
set logscale y
set xlabel "levels"
set xrange [0.5:8.5]
set yrange [5:3000]
set xtics 1
set ytics 10 format "10^{%T}"
set key top left Left reverse
array NAME[2] = ["degree 2", "degree 3"]
do for [p=1:2] {
    set title NAME[p]
    if (p == 1) { set ylabel "condition number" } else { unset ylabel }
    plot data index NAME[p] using 1:2 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.7 title "HB", \
         data index NAME[p] using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.7 title "THB"
}
unset multiplot
