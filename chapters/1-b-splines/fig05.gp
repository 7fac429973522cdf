# Figure 5 -- sections: planar polygon, planar curve (x, y); spatial ... (x, y, z)
set multiplot
set size 0.5,1
set origin 0,0
set title "planar curve, N = 2"
set xlabel "s_1"
set ylabel "s_2"
set xrange [-0.4:7]
set yrange [-0.4:3]
set ytics 1
# the names of the control points stand outside the polygon
array DX[8] = [0.35, 0, 0, -0.2, 0.2, 0, 0, 0]
array DY[8] = [0, 0.2, 0.2, -0.2, -0.2, 0.2, 0.2, -0.25]
plot data index "planar polygon" using 1:2 with linespoints ls 7 dt 2 pt 7 ps 0.7, \
     data index "planar polygon" using ($1+DX[int($0)+1]):($2+DY[int($0)+1]):(sprintf("c_%d", $0)) \
         with labels center tc rgb "#404040", \
     data index "planar curve" using 1:2 with lines ls 1 lw 3
set size 0.5,1
set origin 0.5,0
set title "spatial curve, N = 3" offset 0,-1.4
set xlabel "s_1"
set ylabel "s_2"
set label "s_3" at screen 0.53,0.78
set xrange [-1.4:1.4]
set yrange [-1.4:1.4]
set zrange [0:3]
set xtics 1 offset 0,-0.3 tc rgb "black"
set ytics 1 offset 0.3,-0.2 tc rgb "black"
set ztics 1 tc rgb "black"
set xyplane at 0
set border 31 lw 0.8 lc rgb LIGHT
set view 66,38,1.1,1
splot data index "spatial curve" using 1:2:(0) with lines lw 2 lc rgb LIGHT, \
      data index "spatial polygon" using 1:2:3 with linespoints ls 7 dt 2 pt 7 ps 0.7, \
      data index "spatial curve" using 1:2:3 with lines ls 2 lw 3
unset multiplot
