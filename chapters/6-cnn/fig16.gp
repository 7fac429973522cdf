# Figure 16 -- for the examples signal and image the sections input, filter, turned, prose,
# equation (column, row, value, local)
set terminal svg size 720,530 font "DejaVu Sans,12" background rgb "white"
set output image
unset border
unset tics
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [-1:20]
set yrange [-14.9:0.4]

# where the parts begin: x to the right, y downwards
array PART[5] = ["input", "filter", "turned", "prose", "equation"]
array INK[5] = [RGB[3], RGB[2], RGB[2], 0, 0] # green input, red filter
array X1[5] = [0, 9, 9, 14, 14]
array Y1[5] = [2.3, 1, 3.6, 1, 3.6]
array X2[5] = [1, 9, 9, 15, 15]
array Y2[5] = [8.3, 7, 11.6, 7, 11.6]
ink(p, local) = p == 1 && local == 0 ? 0x606060 : INK[p]
number(v, local) = sprintf(local == 1 ? "{/:Bold %s%d}" : "%s%d", v < 0 ? "−" : "", abs(v))
shade(local) = local == 1 ? 0xd9d9d9 : 0xffffff

set label "(a)" at -0.8,0.1 font ",13"
set label "(b)" at -0.8,-5.9 font ",13"
do for [p=1:2] {
    y = p == 1 ? 1 : 7
    step = p == 1 ? 2.6 : 4.6
    size = p == 1 ? 1 : 3
    set label "input" at 3.5,(p == 1 ? -1.95 : -7.95) center
    set label "filter" at 10.5,-y+0.35 center
    set label "filter, turned" at 10.5,-y-step+0.35 center
    set label "feature map, by the prose" at 16.5,-y+0.35 center
    set label "feature map, by (22)" at 16.5,-y-step+0.35 center
    do for [q=0:1] {
        set label "⋆" at 8,-y-q*step-0.5*size center font ",24"
        set label "=" at 13,-y-q*step-0.5*size center font ",18"
    }
}
plot for [p=1:5] data index "signal ".PART[p] using (X1[p]+$1+0.5):(-Y1[p]-$2-0.5):(0.5):(0.5):(shade($4)) with boxxyerror fs solid border lc rgb "#404040" lc rgb variable, \
     for [p=1:5] data index "image ".PART[p] using (X2[p]+$1+0.5):(-Y2[p]-$2-0.5):(0.5):(0.5):(shade($4)) with boxxyerror fs solid border lc rgb "#404040" lc rgb variable, \
     for [p=1:5] data index "signal ".PART[p] using (X1[p]+$1+0.5):(-Y1[p]-$2-0.5):(number($3, $4)):(ink(p, $4)) with labels tc rgb variable, \
     for [p=1:5] data index "image ".PART[p] using (X2[p]+$1+0.5):(-Y2[p]-$2-0.5):(number($3, $4)):(ink(p, $4)) with labels tc rgb variable
