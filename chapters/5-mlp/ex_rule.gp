# The perceptron's error -- section: errors (sum, squared, criterion)
set terminal svg size 480,320 font "DejaVu Sans,11" background rgb "white"
set output image
set xrange [-3:3]
set yrange [-0.15:5]
set xtics 1
set ytics 1
set xlabel "sum (20) of a sample with label +1"
set key top right samplen 2.5
plot data index "errors" using 1:2 with lines lw 2.4 lc rgb RED title "square of the error", \
     data index "errors" using 1:3 with lines lw 2.4 dt 2 lc rgb BLUE title "perceptron criterion"
