# Figure 12 -- sections: units (layer, unit, y), edges (layer, from, y, to, y)
set terminal svg size 720,290 font "DejaVu Sans,12" background rgb "white"
set output image
stats data index "edges" using 2 name "FROM" nooutput
m = FROM_max + 1
name(j) = j + 1 < m ? sprintf("%d", j + 1) : "m"
unset border
unset tics
set margins 0,0,0,0
set xrange [-0.5:2.45]
set yrange [-2.5:2.5]
set label 1 "m input units" at -0.3,0 center rotate by 90 tc rgb GREEN
set label 2 "output unit" at 1,-0.72 center tc rgb RED
set label 3 "b" at 1.04,0.95 left
set label 4 "x = σ(ω₁p₁ + ⋯ + ωₘpₘ + b)" at 1.33,0 left
set label 5 "σ = sign" at 1.33,-0.6 left
set arrow 1 from 1,1.2 to 1,0.37 lw 1.2 lc rgb "#404040" size screen 0.012,22 filled
set arrow 2 from 1.09,0 to 1.28,0 lw 1.2 lc rgb "#404040" size screen 0.012,22 filled
plot data index "edges" using (0):3:(1):($5-$3) with vectors nohead lw 1.2 lc rgb GREY, \
     data index "edges" using (0.45):(0.55*$3+0.45*$5):(0.08):(0.19) with boxxyerror fs solid noborder lc rgb "white", \
     data index "edges" using (0.45):(0.55*$3+0.45*$5):("ω_{".name($2)."}") with labels, \
     data index "units" using 1:3:($1 == 0 ? RGB[3] : RGB[2]) with points pt 7 ps 3.6 lc rgb variable, \
     data index "units" using ($1 == 0 ? 0 : NaN):3:("p_{".name($2)."}") with labels tc rgb "white", \
     data index "units" using ($1 == 1 ? 1 : NaN):3:("x") with labels tc rgb "white"
