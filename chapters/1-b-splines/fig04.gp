# Figure 4 -- sections: pieces (x, value, piece), hats and bumps (x, value, function)
set multiplot
set size 0.5,1
set origin 0,0
set title "(a) one function of degree 3, four pieces" offset 0,-0.3
set xlabel "x"
set ylabel "β_{j,4}(x)"
set xrange [0:4]
set yrange [-0.25:1]
set xtics 1
set ytics 0.25
do for [i=0:3] {
    set label 1+i sprintf("%d", i + 1) at i + 0.5, -0.17 center tc ls i+1
}
plot for [i=0:3] data index "pieces" every :::i::i using 1:2 with lines lw 1 dt 3 lc rgb COLOR[i+1], \
     for [i=0:3] data index "pieces" every ::60*i:i:60*(i+1):i using 1:2 with lines lw 3 lc rgb COLOR[i+1]
unset label
set ytics 0.5
set yrange [0:1.05]
set xrange [0:1]
set xtics 0.2
set size 0.5,0.5
set origin 0.5,0.5
set title "(b) bases of degree 1 and of degree 2"
unset xlabel
set ylabel "β_{j,2}(x)"
plot for [j=0:5] data index "hats" every :::j::j using 1:2 with lines ls 1+j%6
set origin 0.5,0
unset title
set xlabel "x"
set ylabel "β_{j,3}(x)"
plot for [j=0:6] data index "bumps" every :::j::j using 1:2 with lines ls 1+j%6
unset multiplot
