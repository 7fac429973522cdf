# Why activations bend -- sections: identity, tanh, ReLU (p, x)
set terminal svg size 480,320 font "DejaVu Sans,11" background rgb "white"
set output image
array NAME[3] = ["identity", "tanh", "ReLU"]
array DASH[3] = [1, 3, 1]
array WIDTH[3] = [1.6, 2.4, 2.4]
set xrange [-4:4]
set yrange [0:9]
set xtics 2
set ytics 2
set xlabel "p"
set ylabel "Φ(p)"
set key top left Left reverse samplen 2.5
plot for [i=1:3] data index NAME[i] using 1:2 with lines lw WIDTH[i] dt DASH[i] lc rgb COLOR[i] title NAME[i]
