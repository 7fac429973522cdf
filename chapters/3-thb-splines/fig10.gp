# Figure 10 -- sections: children (x, value, truncated), supports (number, low, high, coefficient,
# truncated), function (x, coarse, truncated), domain (low, high)
set terminal svg size 720,520 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "domain" using (low = $1, high = $2) nooutput
set multiplot
set xrange [-0.05:4.6]
set xtics 0,0.5,4
set lmargin at screen 0.10
set rmargin at screen 0.98
set tmargin at screen 0.975
set bmargin at screen 0.42
set yrange [0:0.6]
set ytics 0.1
set ylabel "value" offset 0.5,0
set xtics format ""
set key top right Left reverse samplen 3.5 spacing 1.35 height 0.5
set object 1 rectangle from low,graph -0.13 to high,graph -0.045 noclip fs solid noborder fc rgb LEVEL[2]
set label 1 "{/:Bold Ω^1}" at (low+high)/2,graph -0.095 center tc rgb "white" front
do for [end in "low high"] {
    set arrow from value(end),graph -0.577 to value(end),graph 0 nohead lw 0.8 dt 2 lc rgb GREY back
}
plot data index "function" using 1:2 with lines ls 11 dt 2 title "β, of level 0", \
     data index "function" using 1:($3 > 0 ? $3 : NaN) with lines ls 11 lw 4 title "trunc^1(β): what is left", \
     data index "children" using 1:($3 == 0 ? $2 : NaN) with lines ls 12 lw 2 title "c_iβ_i, of level 1", \
     data index "children" using 1:($3 == 1 ? $2 : NaN) with lines ls 12 lw 2.2 dt 3 title "dropped, inside Ω^1: c_iβ_i"
unset object
unset label
unset arrow
set tmargin at screen 0.345
set bmargin at screen 0.10
set border 1
unset ylabel
unset ytics
set xtics format "%g"
set xlabel "x"
set yrange [4.6:-0.6]
set label "supports\nof the β_i" at 0,3.2
plot data index "supports" using 2:1:($5 == 0 ? $3-$2 : NaN):(0) with vectors nohead ls 12 lw 3, \
     data index "supports" using 2:1:($5 == 1 ? $3-$2 : NaN):(0) with vectors nohead ls 12 lw 3 dt 3, \
     data index "supports" using (high):1:(sprintf("c%s = %.4f", "₀₁₂₃₄"[$1+1:$1+1], $4)) with labels left offset 0.8,0
unset multiplot
