# Selection -- sections: selected (share, validation, test, their laws),
# bias (models, three biases, three bounds)
set terminal svg size 720,300 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,2 margins 0.09,0.97,0.17,0.90 spacing 0.10
set title "(a) the best of 50 models"
set xlabel "share of mistakes" offset 0,0.4
set ylabel "how often" offset 1,0
set xrange [0.3:0.7]
set yrange [0:0.24]
set xtics 0.1
set ytics 0.05
set key top right samplen 1.5
set arrow 1 from 0.5,0 to 0.5,0.115 nohead lw 1.2 lc rgb "#303030" front
set label 1 "true share" at 0.5,0.115 offset 0.4,0.3
set boxwidth 0.008
set style fill solid
plot data index "selected" using 1:($3 > 0 ? $3 : NaN) with boxes lc rgb "#f3c9ad" title "on the test set", \
     data index "selected" using 1:($2 > 0 ? $2 : NaN) with boxes fs solid 0.75 lc rgb "#4a97c9" title "on the validation set", \
     data index "selected" using 1:4 with points pt 7 ps 0.35 lc rgb "#00324f", \
     data index "selected" using 1:5 with points pt 5 ps 0.35 lc rgb "#a04000"
unset arrow 1
unset label 1
set title "(b) how much better it looks than it is"
set xlabel "models" offset 0,0.4
set ylabel "1/2 less the mean share" offset 1,0
set logscale x 2
set xrange [1:1400]
set yrange [0:0.4]
set xtics (1, 4, 16, 64, 256, 1024)
set ytics 0.1
set key top left samplen 2
array MARK[3] = [7, 5, 9]
plot for [s=1:3] data index "bias" using 1:1+s with linespoints lw 1.8 lc rgb COLOR[s] pt MARK[s] ps 0.6 title sprintf("%d samples", 25 * 4 ** (s - 1)), \
     for [s=1:3] data index "bias" using 1:4+s with lines lw 1 lc rgb GREY dt 3 title (s == 1 ? "bound" : "")
unset multiplot
