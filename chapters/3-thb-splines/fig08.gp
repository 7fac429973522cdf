# Figure 8 -- sections: coarse, fine, active coarse, active fine, basis (x, value, function,
# level), domain (low, high)
set terminal svg size 720,700 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "domain" using (low = $1, high = $2) nooutput
set multiplot layout 5,1 margins 0.085,0.97,0.09,0.96 spacing 0,0.078
set xrange [0:1]
set yrange [0:1.05]
set ytics 0.5
set xtics 0.125 format ""
set ylabel "value" offset 1,0
array NAME[5] = ["coarse", "fine", "active coarse", "active fine", "basis"]
array WHAT[5] = ["(a)  the basis of V^0", "(b)  the basis of V^1", "(c)  active, level 0", "(d)  active, level 1", "(e)  the HB basis"]
do for [p=1:5] {
    set label 2 WHAT[p] at graph 0,1.2
    if (p == 3) {
        set object 1 rectangle from low,graph -0.30 to high,graph -0.07 noclip fs solid noborder fc rgb LEVEL[2]
        set label 1 "{/:Bold Ω^1}" at (low+high)/2,graph -0.21 center tc rgb "white" front
    }
    if (p == 5) {
        set xlabel "x" offset 0,-0.7
        set xtics ("0" 0, "1/8" 0.125, "1/4" 0.25, "3/8" 0.375, "1/2" 0.5, "5/8" 0.625, "3/4" 0.75, "7/8" 0.875, "1" 1) offset 0,-0.8
    }
    plot for [l=0:1] data index NAME[p] using 1:($4 == l ? $2 : NaN) with lines ls 11+l
}
unset multiplot
