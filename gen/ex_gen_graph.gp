# gen graph -- the signal at the nodes of three graphs, exact above and with noise below: the
# greater, the lighter. The label says where the exact one is positive (disks).
#   gen graph --count 3 --nodes 60-90 --radius 0.2 --noise 0.3 --format csv --out graph
load "gen/gallery.gp"
nodes = "< paste -d, ".table("graph", "nodes")." ".table("graph", "labels")
array COLUMN[2] = ["signal", "noisy_signal"]
array X[270]
array Y[270]
place(node) = 90*column("sample") + node + 1
stats nodes using (X[place($2)] = $3, Y[place($2)] = $4) nooutput
x(end) = X[place(column(end))]
y(end) = Y[place(column(end))]
labelled(s, label) = column("label") == label ? only(s, "x") : NaN
set multiplot layout 2,3 margins 0.01,0.99,0.02,0.98 spacing 0.015,0.03
unset colorbox
set cbrange [-1:1]
set palette defined (0 "#08306b", 0.5 "#6baed6", 1 "#ffffff")
set xrange [-0.04:1.04]
set yrange [-0.04:1.04]
do for [c=1:2] {
    do for [s=0:2] {
        plot table("graph", "edges") using (only(s, "row")*0 + x("from")):(y("from")):(x("to") - x("from")):(y("to") - y("from")) with vectors nohead lw 0.7 lc rgb GREY, \
             nodes using (labelled(s, 1)):"y":COLUMN[c] with points pt 7 ps 0.55 lc palette, \
             nodes using (labelled(s, 1)):"y" with points pt 6 ps 0.55 lc rgb "#404040", \
             nodes using (labelled(s, 0)):"y":COLUMN[c] with points pt 5 ps 0.5 lc palette, \
             nodes using (labelled(s, 0)):"y" with points pt 4 ps 0.5 lc rgb "#404040"
    }
}
unset multiplot
