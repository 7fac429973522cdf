# Partition of unity -- sections: HB, THB (x, y, sum)
set multiplot layout 1,2
set border 31 lw 0.8 lc rgb LIGHT
set xyplane at 0
set pm3d depthorder
unset colorbox
set palette defined (0 "#ffffff", 1 "#4f97c4")
set zrange [0:2.1]
set cbrange [0.6:2.1]
set xrange [0:1]
set yrange [0:1]
set xlabel "x_1"
set ylabel "x_2"
set xtics 0.5 offset 0,-0.3 tc rgb "black"
set ytics 0.5 offset 0.5,-0.2 tc rgb "black"
set ztics 1 tc rgb "black"
set view 58,36,1.15,1.1
set title "sum of all HB-splines" offset 0,-2
splot data index "HB" using 1:2:3 with pm3d
set title "sum of all THB-splines"
splot data index "THB" using 1:2:3 with pm3d
unset multiplot
