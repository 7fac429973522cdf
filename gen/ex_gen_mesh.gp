# gen mesh -- a sample of each kind with three levels, and one with two; the finer, the darker.
#   gen mesh --count 1 --cells 4 --kind diagonal --format csv --out diagonal3
#   gen mesh --count 1 --cells 4 --kind boxes --format csv --out boxes3
#   gen mesh --count 1 --cells 4 --kind front --format csv --out front3
#   gen mesh --count 1 --cells 4 --kind scattered --format csv --out scattered3
#   gen mesh --count 1 --seed 1 --cells 6 --levels 2 --kind diagonal --format csv --out diagonal2
#   gen mesh --count 1 --seed 1 --cells 6 --levels 2 --kind boxes --format csv --out boxes2
#   gen mesh --count 1 --seed 1 --cells 6 --levels 2 --kind front --format csv --out front2
#   gen mesh --count 1 --seed 1 --cells 6 --levels 2 --kind scattered --format csv --out scattered2
load "gen/gallery.gp"
array KIND[4] = ["diagonal", "boxes", "front", "scattered"]
low(j, l) = 1.0*j/(cells*2**l)
corner(j) = low(j, column("level"))
set multiplot layout 2,4 margins 0.01,0.99,0.02,0.91 spacing 0.015,0.03
set xrange [0:1]
set yrange [0:1]
do for [levels in "3 2"] {
    cells = levels == 3 ? 4 : 6
    do for [k=1:4] {
        if (levels == 3) { set title KIND[k] offset 0,-0.7 } else { unset title }
        plot for [l=0:2] table(KIND[k].levels, "cells") using (column("level") == l ? 0 : NaN):(0): \
            (corner($4)):(corner($4 + 1)):(corner($5)):(corner($5 + 1)) \
            with boxxyerror fs solid border lc rgb "#404040" lw 0.5 fc rgb CELL[l+1]
    }
}
unset multiplot
