# Backpropagation -- sections: steps (h, relative), each subject by its name (relative)
set terminal svg size 720,470 font "DejaVu Sans,11" background rgb "white"
set output image
array NAME[28] = ["affine", "identity", "sign", "step", "logistic", "tanh", "ReLU", "leaky ReLU", \
    "ELU", "softplus", "GELU", "SiLU", "convolution, signal", "convolution, valid", \
    "convolution, zeros", "convolution, circular", "pooling, largest", "pooling, mean", \
    "graph, spatial", "graph, Chebyshev", "graph, first order", "graph, spectral", \
    "squared error", "hinge", "perceptron criterion", "cross-entropy", \
    "cross-entropy, two classes", "a whole network"]
EXACT = 1e-12 # where a distance of zero is drawn
set mxtics 1
set mytics 1
set multiplot
set tmargin at screen 0.92
set bmargin at screen 0.12
set lmargin at screen 0.105
set rmargin at screen 0.45
set title "(a) a whole network, steps of all sizes"
set xlabel "step h" offset 0,0.4
set ylabel "relative distance" offset 1,0
set logscale xy
set xrange [1e-14:1]
set yrange [1e-12:1]
set xtics 1e-12,1e3 format "10^{%T}"
set ytics 1e-12,1e2 format "10^{%T}"
set label 1 "∼ h²" at 3e-3,3e-7 left
set label 2 "∼ 1/h" at 3e-10,5e-8 right
plot data index "steps" using 1:2 with linespoints lw 1.6 lc rgb BLUE pt 7 ps 0.45
unset label
unset ylabel
set lmargin at screen 0.74
set rmargin at screen 0.975
set title "(b) every layer and every loss" offset -8,0
set xlabel "relative distance" offset 0,0.4
set xrange [EXACT / 3:1.2e-8]
set xtics ("0" EXACT, "10^{-10}" 1e-10, "10^{-9}" 1e-9, "10^{-8}" 1e-8)
unset logscale y
set yrange [28.6:0.4]
set ytics scale 0 font ",9.5" ("" 0)
do for [i=1:28] { set ytics add (NAME[i] i) }
do for [y in "12.5 22.5 27.5"] { set arrow from graph 0,first y to graph 1,first y nohead lw 0.8 lc rgb LIGHT }
plot for [i=1:28] data index NAME[i] using ($1 == 0 ? EXACT : NaN):(i) with points pt 6 ps 0.55 lw 1.4 lc rgb BLUE, \
     for [i=1:28] data index NAME[i] using ($1 > 0 ? $1 : NaN):(i) with points pt 7 ps 0.55 lc rgb RED
unset multiplot
