# Figure 17 -- sections: units (layer, y, kind), connections (layer, y, layer, y, kind, dark),
# counts (layer, connections); kind 0 input, 1 convolutional, 2 fully connected, 3 output
set terminal svg size 720,400 font "DejaVu Sans,11" background rgb "white"
set output image
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
array KIND[4] = [RGB[3], RGB[5], RGB[1], RGB[2]]
array NAME[4] = ["input", "convolutional layers", "fully connected layers", "output"]
array TONE[4] = [0, 0xe8b84a, 0x8fbfdc, 0xe8a478] # of the connections to a layer
set label "connections between neighbouring layers" at 3.5,-5.55 center
do for [k=1:4] {
    stats data index "units" using ($3 == k - 1 ? $1 : NaN) nooutput
    set label NAME[k] at (STATS_min + STATS_max) / 2.0,4.95 center
    set arrow from STATS_min-0.25,4.6 to STATS_max+0.25,4.6 nohead lw 3 lc rgb KIND[k]
}
set xrange [-0.5:7.5]
set yrange [-5.9:5.3]
plot data index "connections" using 1:2:($3-$1):($4-$2):(TONE[int($5)+1]) with vectors nohead lw 1 lc rgb variable, \
     data index "connections" using 1:($6 == 1 ? $2 : NaN):($3-$1):($4-$2) with vectors nohead lw 1.8 lc rgb "#804000", \
     data index "units" using 1:2 with points pt 7 ps 1.75 lc rgb "#404040", \
     data index "units" using 1:2:(KIND[int($3)+1]) with points pt 7 ps 1.6 lc rgb variable, \
     data index "counts" using ($1-0.5):(-5.0):(sprintf("%d", $2)) with labels
