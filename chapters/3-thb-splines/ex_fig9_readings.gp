# Figure 9, other readings -- section: meshes (hierarchical, tensor)
set terminal svg size 640,400 font "DejaVu Sans,11" background rgb "white"
set output image
set xlabel "dimension of the hierarchical space"
set ylabel "dimension of the tensor product"
set xrange [0:700]
set yrange [0:1300]
set xtics 100
set ytics 300
set arrow from 184,0 to 184,1300 nohead lw 1 lc rgb RED
set arrow from 0,729 to 700,729 nohead lw 1 lc rgb RED
set label "184" at 184,1300 center offset 0,0.7 tc rgb RED
set label "729" at 700,729 left offset 0.6,0 tc rgb RED
set rmargin 6
plot data index "meshes" using 1:2 with points pt 7 ps 0.25 lc rgb BLUE
