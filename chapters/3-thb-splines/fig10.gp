# Figure 10 -- sections: children (x, value, truncated), function (x, coarse, truncated),
# domain (low, high)
set terminal svg size 720,380 font "DejaVu Sans,11" background rgb "white"
set output image
set xrange [-0.1:5.2]
set yrange [0:0.6]
set xtics 1
set ytics 0.1
set xlabel "x"
set key top right Left reverse samplen 3 spacing 1.2
plot data index "children" using 1:($3 == 0 ? $2 : NaN) with lines lw 1.4 lc rgb SKY title "finer functions that stay", \
     data index "children" using 1:($3 == 1 ? $2 : NaN) with lines lw 1.4 dt 3 lc rgb GREY title "finer functions inside Ω^1", \
     data index "function" using 1:2 with lines lw 2 dt 2 lc rgb "#404040" title "coarse function", \
     data index "function" using 1:3 with lines lw 3.5 lc rgb BLUE title "truncated function", \
     data index "domain" using 1:(0.004):($2-$1):(0) with vectors nohead lw 6 lc rgb "#d62728", \
     data index "domain" using (0.1*$1+0.9*$2):(0.025):("Ω^1") with labels tc rgb "#d62728"
