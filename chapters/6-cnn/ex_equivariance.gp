# Shift equivariance -- sections: circular, zeros, stride (output, difference)
set terminal svg size 720,260 font "DejaVu Sans,11" background rgb "white"
set output image
array NAME[3] = ["circular", "zeros", "stride"]
array TITLE[3] = ["on a circle", "zeros around the input", "on a circle, stride 2"]
set multiplot layout 1,3 margins 0.085,0.985,0.21,0.90 spacing 0.05
set xlabel "output"
set yrange [-0.05:2]
set ytics 0.5
do for [p=1:3] {
    last = p == 3 ? 15 : 31
    step = p == 3 ? 5 : 10
    set title TITLE[p] offset 0,-0.5
    set xrange [-0.7:last + 0.7]
    set xtics step
    if (p == 1) { set ylabel "|difference|" offset 1,0 } else { unset ylabel; set format y "" }
    if (p == 2) { set key top right samplen 1 } else { unset key }
    plot data index NAME[p] using 1:2 with impulses lw 1.4 lc rgb GREY, \
         data index NAME[p] using 1:($2 == 0 ? 0 : NaN) with points pt 7 ps 0.4 lc rgb BLUE title "equal to the bit", \
         data index NAME[p] using 1:($2 > 0 ? $2 : NaN) with points pt 5 ps 0.6 lc rgb RED title "different"
}
unset multiplot
