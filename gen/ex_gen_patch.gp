# gen patch -- two samples: the control points and points of the surface, their parameters, and the
# neighbours seen from above. The four sides of the boundary have a mark each.
#   gen patch --count 2 --seed 2 --interior 120 --boundary 10 --format csv --out patch
load "gen/gallery.gp"
points = "< paste -d, ".table("patch", "points")." ".table("patch", "labels")
array X[320]
array Y[320]
place(point) = 160*column("sample") + point + 1
stats points using (X[place($2)] = column("noisy_x"), Y[place($2)] = column("noisy_y")) nooutput
x(end) = X[place(column(end))]
y(end) = Y[place(column(end))]
side(j, name) = column("side") == j ? only(s, name) : NaN
array MARK[5] = [7, 5, 6, 9, 4]
array TITLE[3] = ["control points, surface", "parameters", "neighbours"]
array SIDE[5] = [GREY, BLUE, RED, GREEN, PINK]
size(j) = j == 0 ? 0.2 : 0.35
controls = table("patch", "controls")
set multiplot
set xrange [-0.06:1.06]
set yrange [-0.06:1.06]
do for [s=0:1] {
    set tmargin at screen 0.91 - 0.46*s
    set bmargin at screen 0.48 - 0.46*s
    set lmargin at screen 0.343
    set rmargin at screen 0.657
    if (s == 0) { set title TITLE[2] offset 0,-0.7 } else { unset title }
    plot for [j=0:4] points using (side(j, "u")):"v" with points pt MARK[j+1] ps size(j) lc rgb SIDE[j+1]
    set lmargin at screen 0.676
    set rmargin at screen 0.99
    if (s == 0) { set title TITLE[3] } else { unset title }
    plot table("patch", "edges") using (only(s, "row")*0 + x("from")):(y("from")):(x("to") - x("from")):(y("to") - y("from")) with vectors nohead lw 0.5 lc rgb GREY, \
         for [j=0:4] points using (side(j, "noisy_x")):"noisy_y" with points pt MARK[j+1] ps size(j) lc rgb SIDE[j+1]
}
unset lmargin; unset rmargin; unset tmargin; unset bmargin
set label 1 TITLE[1] at screen 0.166,0.96 center
set border 4095 lc rgb LIGHT
set xrange [0:1]
set yrange [0:1]
set zrange [0:0.7]
set xyplane at 0
set view 50,30,1.1,0.9
set size 0.4,0.66
# the control net, 3 x 3
do for [s=0:1] {
    set origin -0.033,0.35-0.46*s
    splot for [i=0:2] controls using "x":"y":"z" every ::9*s+3*i::9*s+3*i+2 with linespoints lw 1 dt 2 lc rgb GREY pt 7 ps 0.4, \
          for [i=0:2] controls using "x":"y":"z" every 3::9*s+i::9*s+i+6 with lines lw 1 dt 2 lc rgb GREY, \
          for [j=0:4] points using (side(j, "x")):"y":"z" with points pt MARK[j+1] ps size(j) lc rgb SIDE[j+1]
    unset label
}
unset multiplot
