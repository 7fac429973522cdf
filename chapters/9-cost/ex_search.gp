# Finding the span -- sections: equal, random (spans, scan, bisection, table)
set terminal svg size 540,360 font "DejaVu Sans,11" background rgb "white"
set output image
set logscale xy
set xlabel "spans"
set ylabel "knots looked at, on average"
set xrange [7:3e7]
set yrange [0.3:3e6]
set xtics 10,10,1e6 format "10^{%T}"
set ytics 1,10 format "10^{%T}"
set mxtics 1
set mytics 1
set key top left Left reverse samplen 2.5
plot data index "equal" using 1:2 with linespoints lw 1.8 dt 2 lc rgb RED pt 4 ps 0.7, \
     data index "random" using 1:4 with points lc rgb GREY pt 6 ps 0.9 lw 1.5 title "table or bisection, random spans", \
     data index "random" using 1:3 with points lc rgb GREY pt 6 ps 0.9 lw 1.5, \
     data index "equal" using 1:3 with linespoints lw 1.8 dt 4 lc rgb GREEN pt 9 ps 0.7, \
     data index "equal" using 1:4 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.6, \
     data index "equal" every ::5::5 using 1:2:("scan") with labels left offset 1,0, \
     data index "equal" every ::5::5 using 1:3:("bisection") with labels left offset 1,0, \
     data index "equal" every ::5::5 using 1:4:("table") with labels left offset 1,0
