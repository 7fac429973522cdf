# Interpolation -- sections: n = 10 (x, runge, polynomial, spline), errors (n, polynomial, spline)
set multiplot layout 1,2
set title "eleven data points"
set xlabel "x"
set yrange [-0.5:2.2]
set xtics 0.5
set ytics 0.5
set key top center samplen 2
plot data index "n = 10" using 1:2 with lines lw 4 lc rgb LIGHT title "1 / (1 + 25 x^2)", \
     data index "n = 10" using 1:3 with lines lw 1.8 dt 2 lc rgb RED title "polynomial of degree 10", \
     data index "n = 10" using 1:4 with lines lw 1.8 lc rgb BLUE title "cubic spline"
set title "largest error"
set xlabel "n (n + 1 data points)"
set logscale y
set yrange [1e-4:1e6]
set ytics 1e-4,100 format "10^{%T}"
set xrange [0:42]
set xtics 10
set key top left Left reverse
plot data index "errors" using 1:2 with linespoints lw 1.8 dt 2 lc rgb RED pt 2 ps 0.6 title "polynomial", \
     data index "errors" using 1:3 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.5 title "cubic spline"
unset multiplot
