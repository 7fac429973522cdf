# Figure 9 -- sections: tensor lines, tensor functions (x, y), cells (boxes, level), functions
# (x, y, level)
set terminal svg size 720,700 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
set border 0
set xrange [-0.02:1.02]
set yrange [-0.02:1.02]
set xtics 0.25
set ytics 0.25
set size square 0.48,0.5
array FILL[3] = [0xffffff, 0xcfe3f1, 0x9ec9e2]
array DOT[3] = [0x404040, 0xd55e00, 0x0072b2]
set origin 0.0,0.5
set title "tensor-product mesh" offset 0,-0.6
plot data index "tensor lines" using 1:2 with lines lw 0.8 lc rgb BLUE
set origin 0.5,0.5
set title "hierarchical mesh"
plot data index "cells" using 1:2:3:4:5:6:(FILL[int($7)+1]) with boxxyerror fs solid noborder lc rgb variable, \
     data index "cells" using 1:2:3:4:5:6 with boxxyerror fs empty border lc rgb BLUE lw 0.8 lc rgb BLUE
set origin 0.0,0.03
set title "its functions, at their Greville points"
plot data index "tensor functions" using 1:2 with points pt 7 ps 0.25 lc rgb "#404040"
set origin 0.5,0.03
set title "its functions, by level"
set key at screen 0.98,0.018 right horizontal samplen 0.5
plot for [l=0:2] data index "functions" using ($3 == l ? $1 : NaN):2 with points pt 7 ps 0.3 lc rgb DOT[l+1] title sprintf("level %d", l)
unset multiplot
