# Knot insertion -- sections: curve, polygon, halved once, halved twice, degree 4, degree 5
set multiplot layout 1,2
set xrange [-0.3:5.8]
set yrange [-2.2:3]
set xtics 1
set ytics 1
set xlabel "s_1"
set ylabel "s_2"
set key bottom left Left reverse samplen 2
array FIRST[2] = ["halved once", "degree 4"]
array SECOND[2] = ["halved twice", "degree 5"]
array TITLE[2] = ["every span halved", "degree raised"]
do for [p=1:2] {
    set title TITLE[p]
    if (p == 2) { unset ylabel }
    plot data index "curve" using 1:2 with lines lw 3 lc rgb LIGHT title "curve", \
         data index "polygon" using 1:2 with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.6 title "given polygon", \
         data index FIRST[p] using 1:2 with linespoints lw 1.3 lc rgb BLUE pt 6 ps 0.7 title FIRST[p], \
         data index SECOND[p] using 1:2 with linespoints lw 1.3 lc rgb RED pt 2 ps 0.5 title SECOND[p]
}
unset multiplot
