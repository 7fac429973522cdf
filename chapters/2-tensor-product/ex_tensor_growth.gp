# Growth -- section: dimensions (step, D = 1, 2, 3)
set terminal svg size 540,360 font "DejaVu Sans,11" background rgb "white"
set output image
set logscale y
set xlabel "halvings of every span"
set ylabel "dimension"
set xrange [-0.2:6.9]
set yrange [4:1e8]
set xtics 1
set ytics 10 format "10^{%T}"
array MARK[3] = [7, 5, 9]
plot for [D=1:3] data index "dimensions" using 1:1+D with linespoints lw 1.8 lc rgb COLOR[D] pt MARK[D] ps 0.7, \
     for [D=1:3] data index "dimensions" every ::6::6 using 1:1+D:(sprintf("D = %d", D)) with labels left offset 0.8,0
