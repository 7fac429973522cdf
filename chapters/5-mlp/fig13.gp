# Figure 13 -- sections: units (layer, unit, y), edges (layer, from, y, to, y), layers (layer,
# units)
set terminal svg size 720,400 font "DejaVu Sans,12" background rgb "white"
set output image
stats data index "layers" using 1 name "LAYER" nooutput
L = int(LAYER_max)
ink(l) = l == 0 ? RGB[3] : l == L ? RGB[2] : RGB[1]
kind(l) = l == 0 ? "input" : l == L ? "output" : "hidden"
units(l) = l == 0 ? "m" : l == L ? "n" : "m".word("₁ ₂ ₃", int(l))
unset border
unset tics
set margins 0,0,0,0
set xrange [-0.5:4.5]
set yrange [-4.6:3.7]
set label 1 "layer" at -0.48,3.3 left
plot data index "edges" using ($1-1):3:(1):($5-$3) with vectors nohead lw 0.7 lc rgb GREY, \
     data index "units" using 1:3:(ink($1)) with points pt 7 ps 2.6 lc rgb variable, \
     data index "layers" using 1:(3.3):(sprintf("%d", $1)) with labels, \
     data index "layers" using 1:(-3.5):(kind($1)):(ink($1)) with labels tc rgb variable, \
     data index "layers" using 1:(-4.1):(sprintf("%s = %d", units($1), $2)) with labels
