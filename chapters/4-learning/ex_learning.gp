# Learning -- sections: vote and product by constant, table, perceptron, network
# (samples, mean, least, greatest)
set terminal svg size 720,310 font "DejaVu Sans,11" background rgb "white"
set output image
array TASK[2] = ["vote", "product"]
array TITLE[2] = ["(a) what most of nine signs are", "(b) the product of the first two"]
array NAME[4] = ["constant", "table", "perceptron", "network"]
array LABEL[4] = ["always +1", "remembers", "Perceptron", "network"]
array TONE[4] = [GREY, GREEN, RED, BLUE]
array MARK[4] = [2, 9, 5, 7]
set multiplot layout 1,2 margins 0.075,0.985,0.17,0.90 spacing 0.08
set xlabel "samples seen" offset 0,0.4
set logscale x 2
set xrange [3.4:300]
set yrange [-0.01:0.6]
set xtics (4, 8, 16, 32, 64, 128, 256)
set ytics 0.1
do for [t=1:2] {
    set title TITLE[t]
    if (t == 1) { set ylabel "share of wrong answers" offset 1,0; unset key } else { unset ylabel; set key at graph 0.02,0.36 left top Left reverse samplen 2 }
    plot for [p=3:4] data index TASK[t] . " " . NAME[p] using 1:3:4 with filledcurves fc rgb (p == 3 ? "#f8e3d6" : "#dcebf5") fs solid noborder, \
         for [p=1:4] data index TASK[t] . " " . NAME[p] using 1:2 with linespoints lw 1.8 lc rgb TONE[p] pt MARK[p] ps 0.7 title LABEL[p]
}
unset multiplot
