# A ReLU network and a spline -- sections: hats (x, sum, terms), units (x, sum, terms), knots
# (t, c)
array DASH[6] = [1, 2, 1, 2, 1, 2]
set multiplot layout 1,2 margins 0.055,0.985,0.13,0.89 spacing 0.08
set xlabel "x" offset 0,0.4
set xrange [0:1]
set xtics 0.25
set title "(a) six linear B-splines"
set yrange [-0.05:1.1]
set ytics 0.5
plot for [j=1:6] data index "hats" using 1:(column(j + 2)) with lines lw 1.3 dt DASH[j] lc rgb COLOR[j], \
     data index "hats" using 1:2 with lines lw 2.8 lc rgb "black", \
     data index "knots" using 1:2 with points pt 7 ps 0.7 lc rgb "black", \
     data index "knots" using 1:(-0.05) with points pt 9 ps 0.7 lc rgb GREY
set title "(b) a constant and five ReLU units"
set yrange [-7:5.5]
set ytics 2
plot for [j=1:6] data index "units" using 1:(column(j + 2)) with lines lw 1.3 dt DASH[j] lc rgb COLOR[j], \
     data index "units" using 1:2 with lines lw 2.8 lc rgb "black", \
     data index "knots" using 1:2 with points pt 7 ps 0.7 lc rgb "black", \
     data index "knots" using 1:(-7) with points pt 9 ps 0.7 lc rgb GREY
unset multiplot
