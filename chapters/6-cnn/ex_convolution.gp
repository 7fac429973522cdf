# Convolutional layers -- sections: convolution, full (input, output, weight), each with its
# counts (connections, parameters)
set terminal svg size 720,390 font "DejaVu Sans,11" background rgb "white"
set output image
array NAME[2] = ["convolution", "full"]
array TITLE[2] = ["convolutional layer", "fully connected layer"]
do for [p=1:2] {
    stats data index NAME[p]." counts" using 1 name "C" nooutput
    stats data index NAME[p]." counts" using 2 name "P" nooutput
    TITLE[p] = sprintf("%s\n%d connections, %d parameters", TITLE[p], C_max, P_max)
}
array FILTER[3] = [RGB[1], RGB[2], RGB[5]]
# a weight of the filter has a colour of its own; those of the full matrix run through greys
shade(p, w) = p == 1 ? FILTER[int(8 * w)] : 0x010101 * int(230 - 150 * (w - 0.125) / 120)
set multiplot layout 1,2 margins 0.085,0.98,0.135,0.90 spacing 0.09
set size ratio -1
set border 31
set xrange [-0.5:31.5]
set yrange [29.5:-0.5]
set xtics 5
set ytics 5
set xlabel "input"
do for [p=1:2] {
    set title TITLE[p] offset 0,-0.4
    if (p == 1) { set ylabel "output" } else { unset ylabel }
    plot data index NAME[p] using 1:2:(0.44):(0.44):(shade(p, $3)) with boxxyerror fs solid noborder lc rgb variable
}
unset multiplot
