# Weights -- sections: linear, quadratic (x, value, weighted, level)
set multiplot layout 2,2
set xrange [0:1]
set yrange [0:1.05]
set ytics 0.5
array NAME[2] = ["linear", "quadratic"]
array TITLE[2] = ["degree 1", "degree 2"]
do for [row=1:2] {
    if (row == 1) {
        set xtics ("0" 0, "1/3" 1.0/3, "2/3" 2.0/3, "1" 1)
    } else {
        set xtics ("0" 0, "1/4" 0.25, "1/2" 0.5, "3/4" 0.75, "1" 1)
        set xlabel "x"
    }
    do for [col=1:2] {
        set title TITLE[row].(col == 1 ? ": HB-splines" : ": times their weights (level 1: 0)")
        plot for [l=0:1] data index NAME[row] using 1:($4 == l ? column(1+col) : NaN) with lines ls 11+l
    }
}
unset multiplot
