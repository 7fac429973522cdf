# Overfitting -- sections: values (x, y), fits (x, law, three fits),
# errors (coefficients, training, new, bias)
set terminal svg size 720,300 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,2 margins 0.065,0.985,0.17,0.90 spacing 0.09
set title "(a) one pattern of noise, and fits with p coefficients"
set xlabel "x" offset 0,0.4
set xrange [-1.06:1.06]
set yrange [-2.2:2.2]
set xtics 0.5
set ytics 1
set key at graph 0.74,0.16 right top maxrows 2 samplen 2 width -1
plot data index "fits" using 1:2 with lines lw 1 lc rgb GREY title "law", \
     data index "fits" using 1:3 with lines lw 1.6 lc rgb GREEN dt 4 title "p = 2", \
     data index "fits" using 1:4 with lines lw 2.4 lc rgb BLUE title "p = 5", \
     data index "fits" using 1:5 with lines lw 1.4 lc rgb RED dt 2 title "p = 12", \
     data index "values" using 1:2 with points pt 7 ps 0.6 lc rgb "#202020"
set title "(b) mean squared errors"
set xlabel "coefficients p" offset 0,0.4
set xrange [0.5:12.5]
set yrange [0:0.2]
set xtics 1,1
set ytics 0.05
set key at graph 1,1 right top samplen 2 maxrows 4
set label 1 "variance of the noise" at 12.4,0.0625 right offset 0,0.5
plot data index "errors" using 1:3 with linespoints lw 1.8 lc rgb RED pt 5 ps 0.7 title "on new values", \
     data index "errors" using 1:2 with linespoints lw 1.8 lc rgb BLUE pt 7 ps 0.7 title "on the values fitted", \
     data index "errors" using 1:4 with lines lw 1.4 lc rgb GREY dt 2 title "without noise", \
     0.0625 with lines lw 1 lc rgb LIGHT
