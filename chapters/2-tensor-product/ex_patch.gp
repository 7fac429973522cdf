# Patches -- sections: lines, net, surface (x, y, z); the patch is their shadow in
# the plane
set multiplot
set size 0.48,1
set origin 0,0
set title "planar patch, N = 2"
set xlabel "s_1"
set ylabel "s_2"
set xrange [-0.6:4.8]
set yrange [-0.8:3.8]
set xtics 1
set ytics 1
set size ratio -1
plot data index "net" using 1:2 with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.5, \
     data index "lines" using 1:2 with lines lw 1 lc rgb BLUE
set size noratio
set size 0.54,1.02
set origin 0.46,0.02
set title "surface, N = 3" offset 0,-2
set border 31 lw 0.8 lc rgb LIGHT
set xyplane at 0
set zrange [0:1.7]
set xtics 2 offset 0,-0.3 tc rgb "black"
set ytics 1 offset 0.5,-0.2 tc rgb "black"
set ztics 1 tc rgb "black"
set label "s_3" at screen 0.49,0.72
set view 56,34,1.1,1.2
set pm3d depthorder
unset colorbox
set palette defined (0 "#ffffff", 1 "#e88a4a")
splot data index "surface" using 1:2:3 with pm3d, \
      data index "net" using 1:2:3 with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.5
unset multiplot
