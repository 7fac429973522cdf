# Stability -- sections: D = 1, degree 2 and so on (levels, hb, thb)
set multiplot layout 1,2
set logscale y
set xlabel "levels"
set xrange [0.5:8.5]
set yrange [5:3000]
set xtics 1
set ytics 10 format "10^{%T}"
do for [D=1:2] {
    set title sprintf("D = %d", D)
    if (D == 1) { set ylabel "condition number" } else { unset ylabel }
    if (D == 1) { unset key } else { set key bottom right Left reverse samplen 2.5 }
    name(d) = sprintf("D = %d, degree %d", D, d)
    plot data index name(3) using 1:2 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "HB, degree 3", \
         data index name(3) using 1:3 with linespoints lw 1.8 dt 2 lc rgb BLUE pt 6 ps 0.7 title "THB, degree 3", \
         data index name(2) using 1:2 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.7 title "HB, degree 2", \
         data index name(2) using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.7 title "THB, degree 2"
}
unset multiplot
