# Definition 3 -- section: right end (function, value), a block for each reading
set multiplot layout 1,4
set style fill solid 0.8 noborder
set boxwidth 0.6
set xlabel "j"
set xrange [-0.6:4.6]
set yrange [0:1.15]
set ytics 0.5
set xtics 1
array NAME[4] = ["every j", "j = n", "j = n + k − 1", "left limit (ours)"]
array HUE[4] = [RED, RED, BLUE, BLUE]
do for [i=0:3] {
    set title NAME[i+1]
    if (i == 0) { set ylabel "β_{j,3}(b)" } else { unset ylabel }
    plot data index "right end" every :::i::i using 1:2 with boxes lc rgb HUE[i+1]
}
unset multiplot
