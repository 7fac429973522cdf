# Regularity -- sections: simple, double, triple (x, value, derivative, function)
set multiplot layout 2,3
array NAME[3] = ["simple", "double", "triple"]
array TITLE[3] = ["knot 1 once", "knot 1 twice", "knot 1 three times"]
set xrange [0:2]
set xtics 1
do for [row=1:2] {
    if (row == 1) { set yrange [0:1.05]; set ytics 0.5; set format x "" }
    else { set yrange [-2.2:2.2]; set ytics 2; set format x; set xlabel "x" }
    do for [m=1:3] {
        # the same sides in both rows, so that a joint can be followed down
        set lmargin at screen 0.10 + (m - 1)*0.31
        set rmargin at screen 0.33 + (m - 1)*0.31
        if (row == 1) { set title TITLE[m] } else { unset title }
        if (m == 1) { set ylabel (row == 1 ? "β_{j,3}(x)" : "β_{j,3}'(x)") } else { unset ylabel }
        plot data index NAME[m] using 1:1+row:(hue($4)) with lines lw 2 lc rgb variable
    }
}
unset multiplot
