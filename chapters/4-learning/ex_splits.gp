# Splits -- sections: epochs (epoch, training, validation, test, risk), floor (least risk),
# stops (repeat, stop, risk, end-training, end-risk)
set terminal svg size 720,300 font "DejaVu Sans,11" background rgb "white"
set output image
stats data index "floor" using 1 nooutput
floor = STATS_min
set multiplot layout 1,2 margins 0.075,0.985,0.17,0.90 spacing 0.09
stats data index "stops" every ::1::1 using 2 nooutput
stop = STATS_max
set title "(a) one training"
set xlabel "epoch" offset 0,0.4
set ylabel "mean loss" offset 1,0
set xrange [0:200]
set yrange [0:1.45]
set xtics 50
set ytics 0.2
set key top left samplen 2
set arrow 1 from stop,0 to stop,0.95 nohead lw 1 lc rgb GREY dt 2
set label 1 "stop" at stop,0.95 offset 0.4,0.2
set label 2 "least possible in truth" at 198,floor right offset 0,0.5
plot data index "epochs" using 1:5 with lines lw 2.4 lc rgb "#303030" title "in truth", \
     data index "epochs" using 1:3 with lines lw 1.6 lc rgb GREEN dt 2 title "validation set", \
     data index "epochs" using 1:2 with lines lw 1.8 lc rgb BLUE title "training set", \
     floor with lines lw 1 lc rgb GREY
unset arrow 1
unset label 1
unset label 2
set title "(b) 20 trainings"
set xlabel "training" offset 0,0.4
unset ylabel
set xrange [0.3:20.7]
set xtics (1, 5, 10, 15, 20)
unset key
set label 1 "epoch 200, in truth" at 0.8,1.35
set label 2 "at the stop, in truth" at 0.8,0.77
set label 3 "least possible in truth" at 0.8,0.44
set label 4 "epoch 200, training set" at 0.8,0.2
plot floor with lines lw 1 lc rgb GREY, \
     data index "stops" using 1:5 with points pt 5 ps 0.6 lc rgb RED, \
     data index "stops" using 1:3 with points pt 6 ps 0.7 lw 1.6 lc rgb "#303030", \
     data index "stops" using 1:4 with points pt 7 ps 0.5 lc rgb BLUE
unset multiplot
