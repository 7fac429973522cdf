# Figure 15 -- sections: each function by its name (z, value, derivative), jumps (sign(0),
# step(0))
set terminal svg size 720,560 font "DejaVu Sans,11" background rgb "white"
set output image
array NAME[11] = ["identity", "sign", "step", "logistic", "tanh", "ReLU", "leaky ReLU", "ELU", "softplus", "GELU", "SiLU"]
COLUMNS = 4
set multiplot
set xrange [-4:4]
set yrange [-1.5:3]
set xtics axis 2 format ""
set ytics axis 1 format ""
set border 0
set zeroaxis lt 1 lw 0.8 lc rgb GREY
set clip two
set size 0.235,0.3
set tmargin 1.6
set bmargin 0.6
set lmargin 1.5
set rmargin 1.5
do for [i=1:11] {
    set origin 0.01 + 0.247*((i-1) % COLUMNS), 0.675 - 0.325*((i-1) / COLUMNS)
    set title NAME[i] offset 0,-0.6
    unset label
    if (i == 1) {
        set label 1 "2" at 2,-0.38 center font ",9"
        set label 2 "2" at -0.25,2 right font ",9"
    }
    # sign and step jump: a dot where the value at 0 is
    jump = i == 2 || i == 3 ? i - 1 : 0
    plot data index NAME[i] using 1:2 with lines lw 2.4 lc rgb BLUE, \
         data index NAME[i] using 1:3 with lines lw 1.6 dt 2 lc rgb RED, \
         data index "jumps" using (0):(jump == 0 ? NaN : column(jump)) with points pt 7 ps 0.7 lc rgb BLUE
}
unset label
unset title
unset zeroaxis
unset tics
set origin 0.751,0.025
set label 1 "σ(z)" at 0.6,1.6 left
set label 2 "σ′(z)" at 0.6,0.4 left
plot "+" using (-3):(1.6):(3):(0) every ::::0 with vectors nohead lw 2.4 lc rgb BLUE, \
     "+" using (-3):(0.4):(3):(0) every ::::0 with vectors nohead lw 1.6 dt 2 lc rgb RED
unset multiplot
