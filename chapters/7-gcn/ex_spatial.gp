# Spatial convolution -- sections: edges (x, y), signal, layer, renumbered (x, y, value, number)
set terminal svg size 720,290 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 1,3 margins 0.01,0.99,0.02,0.90 spacing 0.02,0
unset border
unset tics
unset colorbox
set size ratio -1
set xrange [-0.07:1.07]
set yrange [-0.06:1.03]
set cbrange [0:1]
set palette defined (0 "#ffffff", 1 "#2f86bd")
array NAME[3] = ["signal", "layer", "renumbered"]
array TITLE[3] = ["(a) a signal", "(b) one spatial layer", "(c) the same, renumbered"]
do for [p=1:3] {
    set title TITLE[p]
    plot data index "edges" using 1:2 with lines lw 1.2 lc rgb GREY, \
         data index NAME[p] using 1:2 with points pt 7 ps 2.6 lc rgb "#404040", \
         data index NAME[p] using 1:2:3 with points pt 7 ps 2.3 lc palette, \
         data index NAME[p] using 1:2:(sprintf("%d", $4)) with labels center
}
unset multiplot
