# All tasks -- sections: tasks, perceptron (seen; planes, all, others)
set terminal svg size 460,320 font "DejaVu Sans,11" background rgb "white"
set output image
array TASKS[3]
do for [k=1:3] {
    stats data index "tasks" using k nooutput
    TASKS[k] = STATS_min
}
set xlabel "inputs seen, of 8" offset 0,0.4
set ylabel "share of wrong answers on the others" offset 1,0
set xrange [-0.3:7.3]
set yrange [0.2:0.8]
set xtics 1
set ytics 0.1
set label 1 sprintf("the other %d tasks", TASKS[3]) at 3.5,0.655 center
set label 2 sprintf("all %d tasks", TASKS[2]) at 3.5,0.525 center
set label 3 sprintf("the %d tasks that a plane solves", TASKS[1]) at 2.6,0.30 center
plot data index "perceptron" using 1:4 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.7, \
     data index "perceptron" using 1:3 with linespoints lw 1.8 lc rgb GREY pt 6 ps 0.7, \
     data index "perceptron" using 1:2 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.7
