# gen thb -- graphs of functions of one variable: the curve, its control points, points with noise,
# and the cells below; and of two variables, on the corners of the cells. The finer, the darker.
#   gen thb --count 2 --dim 1 --cells 6 --points 40 --noise 0.03 --format csv --out line
#   gen thb --count 2 --dim 1 --cells 6 --points 1000 --format csv --out line-curve
#   gen thb --count 1 --seed 1 --points 1 --format csv,vtu --out boxes
#   gen thb --count 1 --seed 2 --kind front --points 1 --format csv,vtu --out front
load "gen/gallery.gp"
# the corners of each cell of a VTU file, in two rows, with the level
surface(set) = "< awk 'NR == FNR { level[NR - 2] = $3; next } NF == 3 && !/</ { corner[n++ % 4] = $0 }" \
    ." NF == 3 && !/</ && n % 4 == 0 { l = level[n / 4 - 1];" \
    ." print corner[0], l \"\\n\" corner[1], l \"\\n\\n\" corner[3], l \"\\n\" corner[2], l \"\\n\\n\" }'" \
    ." FS=, ".table(set, "cells")." FS=' ' ".data."/".set."/vtu/train-0000000000000000000.vtu"
low(c1, l) = 1.0*c1/(6*2**l)
level(l, name) = column("level") == l ? only(s, name) : NaN
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.48
set xrange [-0.02:1.02]
set yrange [-1.5:1.1]
set border 0
do for [s=0:1] {
    set tmargin at screen 0.98 - 0.5*s
    set bmargin at screen 0.52 - 0.5*s
    plot for [l=0:2] table("line", "cells") using (level(l, "level")):(0):(low($4, l)):(low($4 + 1, l)):(-1.4):(-1.15) with boxxyerror fs solid border lc rgb "#404040" lw 0.5 fc rgb CELL[l+1], \
         table("line-curve", "points") using (only(s, "x")):"z" smooth unique with lines lw 1.6 lc rgb BLUE, \
         table("line", "points") using (only(s, "noisy_x")):"noisy_z" with points pt 6 ps 0.35 lc rgb RED, \
         for [l=0:2] table("line", "coefficients") using (level(l, "x")):"z" with points ls 11+l
}
unset lmargin; unset rmargin; unset tmargin; unset bmargin
set datafile separator
unset datafile columnheaders
set xrange [0:1]
set yrange [0:1]
set zrange [-1:1]
set xyplane at -1
unset colorbox
set cbrange [0:2]
set palette defined (0 "#e3f0f8", 1 "#f2b48a", 2 "#6fae98")
set view 50,25,1.2,0.7
set pm3d depthorder
set size 0.56,0.7
do for [s=0:1] {
    set origin 0.455,0.38-0.5*s
    splot surface(s == 0 ? "boxes" : "front") using 1:2:3:4 with pm3d
}
unset multiplot
