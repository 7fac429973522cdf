# Depth and width -- sections: polygons (x, y), errors (wide, deep, error)
set terminal svg size 720,320 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot
set label 1 "(a)" at screen 0.015,0.94 font ",12"
set label 2 "(b)" at screen 0.44,0.94 font ",12"
set bmargin at screen 0.17
set tmargin at screen 0.9
set lmargin at screen 0.07
set rmargin at screen 0.4
set xrange [0:1]
set yrange [0:1]
set xtics 0.25
set ytics 0.5
set xlabel "x" offset 0,0.3
set key top left Left reverse samplen 2.5
plot x**2 with lines lw 4 lc rgb LIGHT title "x^2", \
     data index "polygons" every :::0::0 using 1:2 with linespoints lw 1.6 dt 2 pt 6 ps 0.6 lc rgb RED title "2 sides", \
     data index "polygons" every :::1::1 using 1:2 with linespoints lw 1.6 pt 7 ps 0.5 lc rgb BLUE title "4 sides"
unset label
set lmargin at screen 0.56
set rmargin at screen 0.975
set logscale xy
set xrange [5:1000]
set yrange [2e-6:0.2]
set xtics 10
set ytics 10
set format y "10^{%T}"
unset mxtics
unset mytics
set xlabel "parameters"
set ylabel "largest error" offset 1,0
set key top right Left reverse samplen 2.5
plot data index "errors" using 1:3 with linespoints lw 1.6 dt 2 pt 6 ps 0.6 lc rgb RED title "one wide layer", \
     data index "errors" using 2:3 with linespoints lw 1.6 pt 7 ps 0.5 lc rgb BLUE title "three units a layer"
unset multiplot
