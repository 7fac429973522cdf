# Figure 7 -- sections: mesh, refined mesh (x, y), marked (x, y, box), basis, refined basis
# (x, y, value)
set terminal svg size 720,480 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
set border 0
set xrange [0:1]
set yrange [0:1]
set xtics 0.5
set ytics 0.5
set xlabel "x_1" offset 0,0.5
set ylabel "x_2" offset 1,0
set size square 0.33,0.52
array AT[3] = [0.00, 0.335, 0.67]
array NAME[3] = ["initial mesh", "marked cells", "refined mesh"]
do for [p=1:3] {
    set origin AT[p],0.48
    set title NAME[p] offset 0,-0.5
    plot data index "marked" using (p == 2 ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid noborder lc rgb "#f0b48c", \
         data index (p == 3 ? "refined mesh" : "mesh") using 1:2 with lines lw 1 lc rgb BLUE
}
set size nosquare
set xlabel "x_1" offset 0,0.3
set ylabel "x_2" offset -1.5,0.3
set border 31 lw 0.8 lc rgb LIGHT
set xyplane at 0
set pm3d depthorder
unset colorbox
set palette defined (0 "#ffffff", 1 "#4f97c4")
set zrange [0:1]
set cbrange [0:1]
set view 50,40,1.1,0.9
set xtics 0.5 offset 0,-0.3 tc rgb "black"
set ytics 0.5 offset 0.5,-0.2 tc rgb "black"
set ztics 0.5 tc rgb "black"
set size 0.45,0.54
set origin 0.02,-0.03
unset title
set label 1 "initial basis" at screen 0.08,0.46
splot data index "basis" using 1:2:3 with pm3d
set origin 0.53,-0.03
set label 1 "refined basis" at screen 0.58,0.46
splot data index "refined basis" using 1:2:3 with pm3d
unset multiplot
