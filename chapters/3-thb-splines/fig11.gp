# Figure 11 -- sections: mesh, HB, THB (boxes, level, number), HB line, THB line (x, value,
# level)
set terminal svg size 760,520 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
set border 0
set xrange [0:1]
set yrange [0:1]
set xtics 0.5
set ytics 0.5
set cbrange [8:20]
set cbtics 4
set palette defined (0 "#f2f7fb", 1 "#2171b5")
array FILL[3] = [0xffffff, 0xcfe3f1, 0x9ec9e2]
LINE = 0.53125
set arrow 1 from 0,LINE to 1,LINE nohead dt 2 lw 1.5 lc rgb RED front
set size square
unset colorbox
set lmargin at screen 0.05
set rmargin at screen 0.30
set bmargin at screen 0.56
set tmargin at screen 0.93
set title "mesh"
plot data index "mesh" using 1:2:3:4:5:6:(FILL[int($7)+1]) with boxxyerror fs solid noborder lc rgb variable, \
     data index "mesh" using 1:2:3:4:5:6 with boxxyerror fs empty border lc rgb "#404040" lw 0.6 lc rgb "#404040"
set lmargin at screen 0.36
set rmargin at screen 0.61
set title "HB: functions on a cell"
plot data index "HB" using 1:2:3:4:5:6:8 with boxxyerror fs solid border lc rgb "#404040" lw 0.6 fc palette
set colorbox user origin 0.945,0.56 size 0.015,0.37
set lmargin at screen 0.67
set rmargin at screen 0.92
set title "THB: functions on a cell"
plot data index "THB" using 1:2:3:4:5:6:8 with boxxyerror fs solid border lc rgb "#404040" lw 0.6 fc palette
unset colorbox
unset arrow
set size nosquare
set border 3
array TINT[3] = [0x808080, 0xd55e00, 0x0072b2]
set yrange [0:0.8]
set ytics 0.4
set xlabel "x_1"
set bmargin at screen 0.11
set tmargin at screen 0.42
set lmargin at screen 0.06
set rmargin at screen 0.48
set title "HB-splines along the line"
plot data index "HB line" using 1:2:(TINT[int($3)+1]) with lines lw 1.2 lc rgb variable
set lmargin at screen 0.55
set rmargin at screen 0.97
set title "THB-splines along the line"
plot data index "THB line" using 1:2:(TINT[int($3)+1]) with lines lw 1.2 lc rgb variable
unset multiplot
