# Bernstein -- sections: functions (x, beta_0 ..), casteljau (x, y, step), curve (x, y)
set multiplot layout 1,2
set xlabel "x"
set ylabel "β_{j,5}(x)"
set yrange [0:1.05]
set xtics 0.25
set ytics 0.5
set key top center horizontal samplen 1.5
plot for [j=0:4] data index "functions" using 1:2+j with lines ls 1+j title sprintf("j = %d", j)
set key bottom center vertical samplen 2
set xlabel "s_1"
set ylabel "s_2"
set xrange [-0.2:3.6]
set yrange [-0.2:2.8]
set xtics 1
set ytics 1
plot data index "curve" using 1:2 with lines lw 3 lc rgb LIGHT title "curve", \
     data index "casteljau" every :::0::0 using 1:2 with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.7 title "control points", \
     data index "casteljau" every :::1::1 using 1:2 with linespoints lw 1.3 lc rgb BLUE pt 6 ps 0.8 title "averaged once", \
     data index "casteljau" every :::2::2 using 1:2 with linespoints lw 1.3 lc rgb GREEN pt 4 ps 0.8 title "twice", \
     data index "casteljau" every :::3::3 using 1:2 with points lc rgb RED pt 7 ps 1.2 title "three times"
unset multiplot
