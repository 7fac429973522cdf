# Meshes -- sections: lax, strict (x, inside, covered), half cells of [0,2]
set terminal svg size 640,300 font "DejaVu Sans,11" background rgb "white"
set output image
set multiplot layout 2,1 margins 0.05,0.72,0.16,0.90 spacing 0,0.22
set border 1
set xrange [0:2]
set yrange [0:1.2]
unset ytics
set xtics 0.5
set style fill solid noborder
set boxwidth 0.495
array NAME[2] = ["lax", "strict"]
array TITLE[2] = ["Ω^1 = [0, 1/2], a cell of level 1", "Ω^1 = [0, 1], a cell of level 0"]
do for [p=1:2] {
    set title TITLE[p] offset 0,-0.6
    if (p == 1) { set key at screen 0.98,0.80 Left reverse samplen 2 } else { unset key }
    plot data index NAME[p] using 1:($2 == 1 ? 1 : NaN) with boxes lc rgb BLUE title "active, level 1", \
         data index NAME[p] using 1:($2 == 0 && $3 > 0 ? 1 : NaN) with boxes lc rgb "#bfdcee" title "active, level 0", \
         data index NAME[p] using 1:($3 == 0 ? 1 : NaN) with boxes lc rgb RED fs pattern 4 title "in no active cell"
}
unset multiplot
