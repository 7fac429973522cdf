# Figure 11 -- sections: HB, THB (boxes, level, number), HB line, THB line (x, value, level),
# line (x_2)
set terminal svg size 720,780 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "line" using (line = $1) nooutput
stats data index "HB" using 8 name "HB" nooutput
LOW = 0.125; HIGH = 0.5
array KIND[2] = ["HB", "THB"]
set multiplot

# the mesh
set border 0
set xrange [0:1]
set yrange [0:1]
set xtics 0.5
set ytics 0.5
set label 1 "x_1" at graph 0.75,-0.12 center
set label 2 "x_2" at graph -0.06,0.75 right
set lmargin at screen 0.055
set rmargin at screen 0.355
set tmargin at screen 0.945
set bmargin at screen 0.668
set title "(a)  mesh"
set arrow 1 from 0,line to 1,line nohead dt 2 lw 2 lc rgb "black" front
set object 1 rectangle from LOW,LOW to HIGH,HIGH fs empty border lc rgb "black" lw 2.5 front
plot for [l=0:2] data index "HB" using ($7 == l ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid border lc rgb "#404040" lw 0.6 fc rgb CELL[l+1]
unset arrow
unset object
unset label

# functions along the line
set border 3
set lmargin at screen 0.46
set rmargin at screen 0.98
set yrange [0:0.9]
set ytics 0.4
set key top center horizontal samplen 2.5
set ylabel "value" offset 1,0
do for [p=1:2] {
    set tmargin at screen 0.945 - (p-1)*0.23
    set bmargin at screen 0.785 - (p-1)*0.23
    set title sprintf("(%s)  %s-splines on the dashed line", "bc"[p:p], KIND[p])
    if (p == 1) { set xtics format "" } else { set xlabel "x_1" offset 0,0.5; set xtics format "%g"; unset key }
    plot for [l=0:2] data index KIND[p]." line" using 1:($3 == l ? $2 : NaN) with lines ls 11+l title sprintf("level %d", l)
}
unset xlabel
unset ylabel

# how many functions on a cell, inside the frame
set border 0
set xrange [LOW:HIGH]
set yrange [LOW:HIGH]
set xtics 0.125
set ytics 0.125
set palette defined (0 "white", 1 "#505050")
set cbrange [HB_min:HB_max]
unset colorbox
ink(count) = count - HB_min > 0.7 * (HB_max - HB_min) ? 0xffffff : 0x000000
set label 1 "x_1" at graph 0.5,-0.115 center
set label 2 "x_2" at graph -0.03,0.5 right
set tmargin at screen 0.442
set bmargin at screen 0.066
do for [p=1:2] {
    set lmargin at screen 0.08 + (p-1)*0.48
    set rmargin at screen 0.487 + (p-1)*0.48
    set title sprintf("(%s)  number of %s-splines on each cell", "de"[p:p], KIND[p])
    if (p == 2) { set ytics format "" }
    plot data index KIND[p] using 1:2:3:4:5:6:8 with boxxyerror fs solid border lc rgb "#303030" lw 0.8 fc palette, \
         data index KIND[p] using 1:2:(sprintf("%d", $8)):(ink($8)) with labels tc rgb variable
}
unset multiplot
