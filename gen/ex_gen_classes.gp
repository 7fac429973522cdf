# gen classes -- points of both classes, without noise above and with it below; in grey the lines
# that they are drawn from or kept apart by. The separable ones have no noise: two samples, with
# separator and margin.
#   gen classes --count 2 --points 80 --format csv --out separable
#   gen classes --count 1 --points 80 --noise 0.1 --kind xor --format csv --out xor
#   gen classes --count 1 --points 80 --noise 0.1 --kind rings --margin 0.3 --format csv --out rings
#   gen classes --count 1 --points 80 --noise 0.05 --kind spirals --format csv --out spirals
load "gen/gallery.gp"
array KIND[4] = ["separable", "xor", "rings", "spirals"]
array EXTENT[4] = [1.1, 1.1, 1.9, 1.3]
points(k) = "< paste -d, ".table(KIND[k], "points")." ".table(KIND[k], "labels")
# the lines of each kind, p = -1 and 1, and for the separable ones 0, at t in [-1,1], in the
# complex plane
i = {0,1}
separable(p, t) = w*(p*margin - b + 3*i*t)
axis(p, t) = 3*(p < 0 ? t : i*t)
ring(p, t) = (p < 0 ? 1 : 1.6)*exp(i*pi*t)
spiral(p, t) = p*((1 + t)/2 + 0.1)*exp(i*3*pi*(1 + t)/2)
line(k, p, t) = k == 1 ? separable(p, t) : k == 2 ? axis(p, t) : k == 3 ? ring(p, t) : spiral(p, t)
shown(label) = column("label") == label ? only(s, c."1") : NaN
set multiplot layout 2,4 margins 0.01,0.99,0.02,0.91 spacing 0.015,0.03
do for [row=0:1] {
    do for [k=1:4] {
        if (row == 0) { set title KIND[k] offset 0,-0.7 } else { unset title }
        set xrange [-EXTENT[k]:EXTENT[k]]
        set yrange [-EXTENT[k]:EXTENT[k]]
        s = k == 1 ? row : 0
        step = k == 1 ? 1 : 2
        c = k > 1 && row == 1 ? "noisy_x" : "x"
        stats table(KIND[1], "separator") using (w = $3 + i*$4, b = $5, margin = $6) every ::s::s nooutput
        plot for [p=-1:1:step] [t=-1:1] "+" using (real(line(k, p, $1))):(imag(line(k, p, $1))) with lines ls (k == 1 && p ? 8 : 7), \
             points(k) using (shown(1)):(column(c."2")) with points pt 7 ps 0.3 lc rgb BLUE, \
             points(k) using (shown(-1)):(column(c."2")) with points pt 4 ps 0.35 lc rgb RED
    }
}
unset multiplot
