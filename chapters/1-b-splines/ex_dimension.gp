# Definitions 1 and 2 -- section: cases (dimension, k+m, printed)
set xlabel "dimension, by elimination"
set ylabel "value of the formula"
set xrange [0:27]
set yrange [0:42]
set key top left Left reverse
plot x with lines ls 7 title "equal", \
     data index "cases" using 1:2 with points pt 6 ps 1 lw 1.5 lc rgb BLUE title "k + m", \
     data index "cases" using 1:3 with points pt 2 ps 0.7 lw 1.5 lc rgb RED title "(m + 1) + m, as printed"
