# A spline and a network -- sections: example (x, function, spline, net), linear, cubic, net
# (parameters, error)
set mxtics 1
set mytics 1
set multiplot layout 1,2 margins 0.075,0.985,0.13,0.89 spacing 0.10
set title "(a) seven parameters"
set xlabel "x" offset 0,0.4
set xrange [-1:1]
set yrange [-0.15:1.35]
set xtics 0.5
set ytics 0.5
set key top left Left reverse samplen 2.5
plot data index "example" using 1:2 with lines lw 5 lc rgb LIGHT title "1 / (1 + 25 x²)", \
     data index "example" using 1:3 with lines lw 1.8 lc rgb BLUE title "cubic spline", \
     data index "example" using 1:4 with lines lw 1.8 dt 2 lc rgb RED title "network"
set title "(b) error against parameters"
set xlabel "parameters" offset 0,0.4
set logscale xy
set xrange [3.7:55]
set yrange [1e-5:1]
set xtics (4, 7, 13, 25, 49)
set ytics 1e-5,10 format "10^{%T}"
set key bottom left Left reverse samplen 2.5
plot data index "linear" using 1:2 with linespoints lw 1.2 lc rgb GREY pt 1 ps 0.4 title "linear spline", \
     data index "cubic" using 1:2 with linespoints lw 1.6 lc rgb BLUE pt 7 ps 0.4 title "cubic spline", \
     data index "net" using 1:2 with points pt 4 ps 0.9 lw 1.4 lc rgb RED title "network, five seeds"
unset multiplot
