# Stopping -- sections: risk (epoch, risk), validation (epoch, loss; a curve a set),
# least (epoch, loss, risk), means (samples, validation, test, risk, least risk)
set terminal svg size 720,300 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,2 margins 0.075,0.985,0.17,0.90 spacing 0.10
set title "(a) one training, nine validation sets of 25"
set xlabel "epoch" offset 0,0.4
set ylabel "mean loss" offset 1,0
set xrange [0:100]
set yrange [0.15:1]
set xtics 20
set ytics 0.2
set key bottom right samplen 2
plot data index "validation" using 1:2 with lines lw 1 lc rgb "#8fbfdd" title "on a validation set", \
     data index "risk" using 1:2 with lines lw 2.6 lc rgb "#303030" title "in truth", \
     data index "least" using 1:2:(0):($3 - $2) with vectors nohead lw 1 lc rgb BLUE, \
     data index "least" using 1:2 with points pt 7 ps 0.6 lc rgb BLUE title "where it stops"
set title "(b) of the network selected, 2000 sets of each size"
set xlabel "samples in the set" offset 0,0.4
set ylabel "mean loss" offset 1,0
set logscale x 2
set xrange [18:560]
set yrange [0.55:0.66]
set xtics (25, 100, 400)
set ytics 0.02
set key top right samplen 2
plot data index "means" using 1:3 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.8 title "on a test set", \
     data index "means" using 1:4 with lines lw 2 lc rgb "#303030" dt 2 title "in truth", \
     data index "means" using 1:2 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.8 title "on its validation set"
unset multiplot
