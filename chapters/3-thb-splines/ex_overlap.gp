# Overlap -- sections: random (degree, hb, thb), wide, narrow (levels, hb, thb)
set multiplot layout 1,2
set title "random meshes"
set xlabel "HB-splines, mean over active cells"
set ylabel "THB-splines, mean over active cells"
set xrange [0:40]
set yrange [0:40]
set xtics 10
set ytics 10
set key top left Left reverse samplen 1
array MARK[3] = [6, 4, 8]
plot x with lines ls 7 title "equal", \
     for [d=1:3] data index "random" using ($1 == d ? $2 : NaN):3 with points pt MARK[d] ps 0.7 lw 1.3 lc rgb COLOR[d] title sprintf("degree %d", d)
set title "refined around the middle, degree 2"
set xlabel "levels"
set ylabel "functions, mean over active cells"
set xrange [0.5:7.5]
set yrange [0:25]
set xtics 1
set ytics 5
set key top left Left reverse samplen 2.5
plot data index "wide" using 1:2 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.7 title "HB, 4 × 4 cells refined", \
     data index "narrow" using 1:2 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7 title "HB, 2 × 2 cells", \
     data index "narrow" using 1:3 with linespoints lw 1.8 dt 2 lc rgb BLUE pt 6 ps 0.7 title "THB, 2 × 2 cells", \
     data index "wide" using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.7 title "THB, 4 × 4 cells"
unset multiplot
