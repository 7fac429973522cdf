# Figure 6 -- sections: degree 3, degree 2 (x, value, function), upper, lower, largest
# (x, y, value), grid (x, y)
set terminal svg size 720,620 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
set label 1 "(a)" at screen 0.02,0.97 font ",12"
set label 2 "(b)" at screen 0.50,0.97 font ",12"
set label 3 "(c)" at screen 0.02,0.475 font ",12"
set label 4 "(d) all functions, the largest at each point" at screen 0.50,0.475 font ",12"
set xrange [0:1]
set xtics 0.5
set ytics 0.5
set yrange [0:1.05]
set size 0.48,0.25
set origin 0,0.75
set ylabel "β_{j,4}(x_1)"
plot data index "degree 3" using 1:2:(hue($3)) with lines lw 2 lc rgb variable
unset label
set origin 0,0.5
set ylabel "β_{j,3}(x_2)"
plot data index "degree 2" using 1:2:(hue($3)) with lines lw 2 lc rgb variable

# (c) square, by margins in parts of the screen
set lmargin at screen 0.11
set rmargin at screen 0.42
set bmargin at screen 0.09
set tmargin at screen 0.45
set xlabel "x_1"
set ylabel "x_2"
set yrange [0:1]
set border 0
plot data index "grid" using 1:2 with lines lw 1.2 lc rgb BLUE

# (b), (d) surfaces, far cells first; a darker shade is higher
set lmargin -1
set rmargin -1
set bmargin -1
set tmargin -1
set border 31 lw 0.8 lc rgb LIGHT
set xyplane at 0
set pm3d depthorder
unset colorbox
set palette defined (0 "#ffffff", 1 "#4f97c4")
set view 60,40,1.15,1
set zrange [0:0.6]
set cbrange [0:0.6]
set xlabel "x_1" offset 0,0.3
set ylabel "x_2" offset -1.5,0.3
set xtics 0.5 offset 0,-0.3 tc rgb "black"
set ytics 0.5 offset 0.5,-0.2 tc rgb "black"
set ztics 0.3 tc rgb "black"
set size 0.44,0.33
set origin 0.53,0.72
set title "β_{4,4}(x_1) β_{1,3}(x_2)" offset 0,-0.9
splot data index "upper" using 1:2:3 with pm3d
set origin 0.53,0.475
set title "β_{3,4}(x_1) β_{5,3}(x_2)" offset 0,-0.9
splot data index "lower" using 1:2:3 with pm3d
unset title
set zrange [0:1]
set cbrange [0:1]
set ztics 0.5
set view 50,40,1.15,0.9
set size 0.5,0.47
set origin 0.48,0
splot data index "largest" using 1:2:3 with pm3d
unset multiplot
