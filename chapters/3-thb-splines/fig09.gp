# Figure 9 -- sections: counts (cells, functions of the tensor product, then of each level), tensor
# lines, tensor functions (x, y), cells (boxes, level), functions (x, y, level)
set terminal svg size 720,800 font "DejaVu Sans,11" background rgb "white"
set output image
array cells[4]
array functions[4]
stats data index "counts" using (i = int($0) + 1, cells[i] = $1, functions[i] = $2) nooutput
set multiplot
set border 0
set xrange [0:1]
set yrange [0:1]
set xtics 0.25
set ytics 0.25
set xlabel "x_1" offset 0,0.6
set label "x_2" at graph -0.07,1.06 center
set lmargin at screen 0.075
set rmargin at screen 0.485
set tmargin at screen 0.957
set bmargin at screen 0.588
set title sprintf("tensor-product mesh: %d cells", cells[1]) offset 0,-0.3
plot data index "tensor lines" using 1:2 with lines lw 0.8 lc rgb "#404040"
set lmargin at screen 0.57
set rmargin at screen 0.98
set title sprintf("hierarchical mesh: %d cells", sum [i=2:4] cells[i])
plot for [l=0:2] data index "cells" using ($7 == l ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid border lc rgb "#404040" lw 0.8 fc rgb CELL[l+1]
set lmargin at screen 0.075
set rmargin at screen 0.485
set tmargin at screen 0.472
set bmargin at screen 0.103
set title sprintf("its %d functions", functions[1])
plot data index "tensor functions" using 1:2 with points pt 7 ps 0.35 lc rgb "#404040"
set lmargin at screen 0.57
set rmargin at screen 0.98
set title sprintf("its %d functions", sum [i=2:4] functions[i])
do for [l=0:2] {
    set label 11+l sprintf("level %d: %d", l, functions[l+2]) at screen 0.58+0.15*l,0.014 offset 0.8,-0.2 point ls 11+l
}
plot for [l=0:2] data index "functions" using ($3 == l ? $1 : NaN):2 with points ls 11+l
unset multiplot
