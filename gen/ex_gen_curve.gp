# gen curve -- two samples of each call: the control polygon, the points with noise, and the curve,
# which is the same at other parameters.
#   gen curve --count 2 --seed 1 --controls 4-8 --law uniform --parameters pinned --points 30-50 --noise 0.02 --format csv --out uniform
#   gen curve --count 2 --seed 1 --controls 4-8 --law uniform --parameters equal --points 200 --format csv --out uniform-curve
#   gen curve --count 2 --seed 1 --law walk --points 60 --noise 0.1 --format csv --out walk
#   gen curve --count 2 --seed 1 --law walk --parameters equal --points 200 --format csv --out walk-curve
#   gen curve --count 2 --seed 3 --law uniform --dim 3 --degree 2 --points 60 --noise 0.02 --format csv --out space
#   gen curve --count 2 --seed 3 --law uniform --dim 3 --degree 2 --parameters equal --points 200 --format csv --out space-curve
load "gen/gallery.gp"
array SET[3] = ["uniform", "walk", "space"]
array TITLE[3] = ["cubic, 4 to 8 control points", "random walk", "quadratic, in space"]
curve(k) = table(SET[k]."-curve", "points")
set multiplot
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set view 68,28,1,1.2
set xyplane at 0
do for [s=0:1] {
    do for [k=1:2] {
        set lmargin at screen 0.01 + 0.333*(k-1)
        set rmargin at screen 0.323 + 0.333*(k-1)
        set tmargin at screen 0.91 - 0.46*s
        set bmargin at screen 0.48 - 0.46*s
        if (s == 0) { set title TITLE[k] offset 0,-0.7 } else { unset title }
        plot table(SET[k], "controls") using (only(s, "x")):"y" with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.4, \
             table(SET[k], "points") using (only(s, "noisy_x")):"noisy_y" with points pt 6 ps 0.35 lc rgb RED, \
             curve(k) using (only(s, "x")):"y" with lines lw 1.6 lc rgb BLUE
    }
}
unset title
set border 4095 lc rgb LIGHT
unset lmargin; unset rmargin; unset tmargin; unset bmargin
set label 1 TITLE[3] at screen 0.833,0.96 center
do for [s=0:1] {
    set size 0.4,0.62
    set origin 0.633,0.4-0.46*s
    splot [0:1] [0:1] [0:1] table(SET[3], "controls") using (only(s, "x")):"y":"z" with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.4, \
         table(SET[3], "points") using (only(s, "noisy_x")):"noisy_y":"noisy_z" with points pt 6 ps 0.35 lc rgb RED, \
         curve(3) using (only(s, "x")):"y":"z" with lines lw 1.6 lc rgb BLUE
    unset label
}
unset multiplot
