# Meshes -- sections: lax, strict (low, high, level; -1 for a hole), cells of [0,2]
set terminal svg size 640,350 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 2,1 margins 0.04,0.96,0.14,0.91 spacing 0,0.21
set border 1
set xrange [0:2]
set yrange [-0.45:1]
unset ytics
set xtics 0.5
array NAME[2] = ["lax", "strict"]
array WHAT[3] = ["in no active cell", "active, level 0", "active, level 1"]
do for [p=1:2] {
    set title "Ω¹ is a cell of level ".(2 - p) offset 0,-0.4
    stats data index NAME[p] using ($3 == 1 ? $1 : NaN) name "LOW" nooutput
    stats data index NAME[p] using ($3 == 1 ? $2 : NaN) name "HIGH" nooutput
    set label 1 "{/:Bold Ω^1}" at (LOW_min + HIGH_max)/2,-0.26 center tc rgb "white" front
    if (p == 2) { set xlabel "x" offset 0,0.4 }
    plot for [l=0:1] data index NAME[p] using ($3 == l ? $1 : NaN):(0):1:2:(0):(1) with boxxyerror fs solid border lc rgb "#404040" lw 1.5 fc rgb CELL[l+1], \
         data index NAME[p] using 1:(0):1:($3 == -1 ? $2 : $1):(0):(1) with boxxyerror fs pattern 4 border lc rgb "#404040" lw 1.5 fc rgb "#404040", \
         data index NAME[p] using ($3 == 1 ? $1 : NaN):(0):1:2:(-0.4):(-0.1) with boxxyerror fs solid noborder fc rgb LEVEL[2], \
         data index NAME[p] using (($1+$2)/2):($3 == -1 ? -0.26 : 0.5):(WHAT[int($3)+2]) with labels
}
unset multiplot
