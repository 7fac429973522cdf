# Figure 9, other readings -- sections: meshes, printed, marked (hierarchical, tensor)
set terminal svg size 640,420 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "printed" using (hierarchical = $1, tensor = $2) nooutput
set xlabel "dimension of the hierarchical space"
set ylabel "dimension of the tensor product"
set xrange [0:1200]
set yrange [0:1200]
set xtics 200
set ytics 200
set arrow from hierarchical,0 to hierarchical,1200 nohead lw 1 lc rgb RED
set arrow from 0,tensor to 1200,tensor nohead lw 1 lc rgb RED
set label sprintf("%d", hierarchical) at hierarchical,1200 center offset 0,0.7 tc rgb RED
set label sprintf("%d", tensor) at 1200,tensor left offset 0.6,0 tc rgb RED
set rmargin 6
name(row) = row == 0 ? "Figure 9" : "on 4 × 4 cells"
x(row) = row == 0 ? 600 : 420 # where the name stands
y(row) = row == 0 ? 560 : 240
plot data index "meshes" using 1:2 with points pt 7 ps 0.25 lc rgb BLUE, \
     data index "marked" using (x($0)):(y($0)):($1 - x($0)):($2 - y($0)) with vectors nohead lw 1 lc rgb "black", \
     data index "marked" using 1:2 with points pt 6 ps 1.6 lw 2 lc rgb "black", \
     data index "marked" using (x($0)):(y($0)):(sprintf("%s: (%d, %d)", name($0), $1, $2)) with labels left offset 0.5,0
