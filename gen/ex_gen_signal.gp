# gen signal -- images of each kind, without noise above and with it below; then sequences, without
# noise on the left and with it on the right. The greater, the darker.
#   gen signal --count 2 --seed 1 --kind bars --format csv --out bars
#   gen signal --count 2 --seed 6 --kind edges --format csv --out edges
#   gen signal --count 2 --seed 6 --kind shifts --format csv --out shifts
#   gen signal --count 4 --kind shifts --height 1 --width 24 --format csv --out sequences
load "gen/gallery.gp"
array KIND[3] = ["bars", "edges", "shifts"]
array NAME[2] = ["clean", "noisy"]
unset colorbox
set palette defined (0 "#ffffff", 1 "#202020")
set cbrange [-0.2:1.2]
set multiplot
do for [p=1:2] {
    set xrange [0.5:8.5]
    set yrange [7.5:-0.5]
    set tmargin at screen 1.22 - 0.31*p
    set bmargin at screen 0.94 - 0.31*p
    do for [k=1:3] {
        if (p == 1) { set label 1 KIND[k] at screen 0.166 + 0.333*(k-1),0.96 center }
        do for [s=0:1] {
            left = 0.01 + 0.333*(k-1) + 0.161*s
            set lmargin at screen left
            set rmargin at screen left + 0.152
            plot for [j=1:8] table(KIND[k], NAME[p]) using (j):(only(s, "row")):(0.5):(0.5):sprintf("p%d", j) with boxxyerror fs solid noborder fc palette
            unset label
        }
    }
    set xrange [0.5:24.5]
    set yrange [3.5:-0.5]
    set tmargin at screen 0.27
    set bmargin at screen 0.02
    set lmargin at screen 0.01 + 0.497*(p-1)
    set rmargin at screen 0.487 + 0.497*(p-1)
    plot for [j=1:24] table("sequences", NAME[p]) using (j):"sample":(0.5):(0.4):sprintf("p%d", j) with boxxyerror fs solid noborder fc palette
}
unset multiplot
