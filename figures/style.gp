# style.gp -- the one look of every figure, read before the figure's own script, which sets
# only what is particular to it. Needs: data, image (figures/draw.sh).
set terminal svg size 720,360 font "DejaVu Sans,11" background rgb "white"
set output image
set encoding utf8
set colorsequence podo
set border 3 lw 0.8 lc rgb "#404040"
set tics nomirror out scale 0.6
set key noautotitle
set samples 200

# podo: Okabe and Ito's colours, readable with any colour vision
BLUE = "#0072b2"; RED = "#d55e00"; GREEN = "#009e73"; PINK = "#cc79a7"
GOLD = "#e69f00"; SKY = "#56b4e9"; GREY = "#808080"; LIGHT = "#d0d0d0"
array COLOR[6] = [BLUE, RED, GREEN, PINK, GOLD, SKY]
array RGB[6] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9]
hue(j) = RGB[int(j) % 6 + 1]
do for [i=1:6] { set style line i lw 2 lc rgb COLOR[i] pt 7 ps 0.6 }
set style line 7 lw 1 lc rgb GREY
set style line 8 lw 0.8 lc rgb LIGHT

# The levels of a hierarchy look alike in every picture: level 0 blue, 1 vermilion, 2 dark
# green. In grey their lines differ in width (the finer the level, the thinner), their points
# in shape, their cells (CELL) in tone. A bar for a domain Omega^l has the colour of level l.
array LEVEL[3] = [0x0072b2, 0xd55e00, 0x00543d]
array CELL[3] = [0xe3f0f8, 0xf2b48a, 0x6fae98]
set style line 11 lw 2.4 lc rgb LEVEL[1] pt 6 ps 0.7
set style line 12 lw 1.6 lc rgb LEVEL[2] pt 5 ps 0.55
set style line 13 lw 1.1 lc rgb LEVEL[3] pt 9 ps 0.55
