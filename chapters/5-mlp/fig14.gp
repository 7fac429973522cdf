# Figure 14 -- sections: layer (y, value), edges (y, y, weight), next (y, bias, sum, value)
set terminal svg size 720,400 font "DejaVu Sans,12" background rgb "white"
set output image
unset border
unset tics
set margins 0,0,0,0
set xrange [-0.65:4.55]
set yrange [-3.1:3.5]
number(v) = sprintf("%s%g", v < 0 ? "−" : "", abs(v))
SPREAD = 2            # between two units of a column
SUM = 2.3; OUT = 3.6  # where the sums stand, and the values behind the activation
PART = 0.25           # how far along an edge its weight stands
set label 1 "φ̂^{(ℓ)}" at 0,3.15 center
set label 2 "W^{(ℓ+1)}" at PART*SUM,3.15 center
set label 3 "φ^{(ℓ+1)}" at SUM,3.15 center
set label 4 "φ̂^{(ℓ+1)}" at OUT,3.15 center
plot data index "edges" using (0):($3 < 0 ? NaN : SPREAD*$1):(SUM):(SPREAD*($2-$1)) with vectors nohead lw 1.4 lc rgb GREY, \
     data index "edges" using (0):($3 < 0 ? SPREAD*$1 : NaN):(SUM):(SPREAD*($2-$1)) with vectors nohead lw 1.4 dt 2 lc rgb GREY, \
     data index "edges" using (PART*SUM):(SPREAD*(PART*$2+(1-PART)*$1)):(0.05+0.03*strlen(number($3))):(0.16) with boxxyerror fs solid noborder lc rgb "white", \
     data index "edges" using (PART*SUM):(SPREAD*(PART*$2+(1-PART)*$1)):(number($3)) with labels, \
     data index "layer" using (-0.65):(SPREAD*$1):(0.47):(0) with vectors nohead lw 1.4 dt 3 lc rgb GREY, \
     data index "layer" using (0):(SPREAD*$1) with points pt 7 ps 4.4 lc rgb BLUE, \
     data index "layer" using (0):(SPREAD*$1):(number($2)) with labels tc rgb "white", \
     data index "next" using (SUM):(SPREAD*$1) with points pt 7 ps 4.4 lc rgb BLUE, \
     data index "next" using (SUM):(SPREAD*$1) with points pt 7 ps 4.0 lc rgb "white", \
     data index "next" using (SUM):(SPREAD*$1):(number($3)) with labels, \
     data index "next" using (SUM):(SPREAD*$1+0.68):("b = ".number($2)) with labels, \
     data index "next" using (SUM+0.22):(SPREAD*$1):(OUT-SUM-0.45):(0) with vectors lw 1.4 lc rgb "#404040" size screen 0.012,22 filled, \
     data index "next" using (0.5*(SUM+OUT)):(SPREAD*$1+0.25):("ReLU") with labels, \
     data index "next" using (OUT):(SPREAD*$1) with points pt 7 ps 4.4 lc rgb BLUE, \
     data index "next" using (OUT):(SPREAD*$1):(number($4)) with labels tc rgb "white", \
     data index "next" using (OUT+0.18):($4 == 0 ? NaN : SPREAD*$1):(0.7):(0) with vectors nohead lw 1.4 dt 3 lc rgb GREY
