# gen scatter -- the noisy heights in space, and the places of the points below: the greater the
# exact height, the darker. Where there are voids, they are grey disks.
#   gen scatter --count 1 --points 250 --noise 0.03 --format csv --out franke
#   gen scatter --count 1 --points 300 --noise 0.03 --surface ridge --sampling graded --format csv --out ridge
#   gen scatter --count 1 --points 350 --noise 0.03 --surface peak --sampling voids --format csv --out peak
#   gen scatter --count 1 --points 250 --noise 0.03 --surface step --format csv --out step
load "gen/gallery.gp"
array SURFACE[4] = ["franke", "ridge", "peak", "step"]
array TITLE[4] = ["Franke, uniform", "ridge, graded", "peak, voids", "step, uniform"]
points(k) = table(SURFACE[k], "points")
unset colorbox
set palette defined (0 "#9ecae1", 0.5 "#3182bd", 1 "#08204b")
set xrange [0:1]
set yrange [0:1]
set multiplot
set border 4095 lc rgb LIGHT
set view 60,30,1.15,0.95
set xyplane 0.1
set size 0.29,0.72
do for [k=1:4] {
    set origin 0.2475*(k-1) - 0.021,0.30
    set label 1 TITLE[k] at screen 0.124 + 0.2475*(k-1),0.96 center
    splot points(k) using "u":"v":"noisy_z":"z" with points pt 7 ps 0.2 lc palette
}
unset label
set border 31 lc rgb "#404040"
set tmargin at screen 0.42
set bmargin at screen 0.02
do for [k=1:4] {
    set lmargin at screen 0.01 + 0.2475*(k-1)
    set rmargin at screen 0.2375 + 0.2475*(k-1)
    if (k == 3) {
        plot table("peak", "voids") using "u":"v":"radius" with circles fs solid noborder fc rgb LIGHT, \
             points(k) using "u":"v":"z" with points pt 7 ps 0.2 lc palette
    } else {
        plot points(k) using "u":"v":"z" with points pt 7 ps 0.2 lc palette
    }
}
unset multiplot
