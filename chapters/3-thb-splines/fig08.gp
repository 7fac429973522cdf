# Figure 8 -- sections: coarse, fine, active coarse, active fine, basis (x, value, function,
# level), domain (low, high)
set terminal svg size 720,620 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 5,1 margins 0.14,0.97,0.07,0.97 spacing 0,0.035
set xrange [0:1]
set yrange [0:1.05]
set ytics 0.5
set xtics 0.125 format ""
array NAME[5] = ["coarse", "fine", "active coarse", "active fine", "basis"]
array PANEL[5] = ["(a)", "(b)", "(c)", "(d)", "(e)"]
array WHAT[5] = ["V^0", "V^1", "A^0", "A^1", "H"]
do for [p=1:5] {
    if (p == 5) {
        set xlabel "x"
        set xtics ("0" 0, "1/8" 0.125, "1/4" 0.25, "3/8" 0.375, "1/2" 0.5, "5/8" 0.625, "3/4" 0.75, "7/8" 0.875, "1" 1)
    }
    set ylabel PANEL[p]."   ".WHAT[p] rotate by 0 offset 1,0
    plot data index NAME[p] using 1:2:($4 == 0 ? 0x0072b2 : 0x009e73) with lines lw 1.8 lc rgb variable, \
         data index "domain" using 1:(0.02):(p >= 3 ? $2 - $1 : NaN):(0) with vectors nohead lw 5 lc rgb "#d62728"
}
unset multiplot
