#!/bin/sh
# gen_families_test.sh -- what is in the sets of each family is what its help says, recomputed by
# awk from the ground truth that the set stores. Runs in the folder of the Makefile; BUILD is the
# folder of the programs.
#
# Tolerances: awk computes in doubles, in another order and with the system's exp, sin and cos,
# which differ from ours by an ulp or two. The sums below have at most a hundred terms of size up
# to 10, so 1e-12 is several times what can come together.
# shellcheck disable=SC2016  # awk's dollars, on purpose
set -u

# shellcheck source=tests/gen.inc
. tests/gen.inc

# make FAMILY OPTION ... -- a set of that name in the folder `set`; no table has two columns of one name
make() {
    rm -rf set
    "$gen" "$@" --out set >"$said" 2>&1 || result 1 "families: gen $*"
    for file in set/*/train-*.csv; do
        [ -e "$file" ] || continue
        head -n 1 "$file" | tr , '\n' | sort | uniq -d >"$said"
        [ ! -s "$said" ] || result 1 "families: gen $*: columns of one name in $file"
    done
}

# table ARRAY -- the first shard of the train split of an array, without its header
table() {
    sed 1d "set/$1/train-00000-of-00001.csv"
}

# holds NAME AWK ARRAY ... -- the awk program, which reads these arrays one behind the other, ends
# with 0; while it reads the k-th, `part` is k. `near(a, b)` says if two numbers agree.
holds() {
    name=$1
    program=$2
    shift 2
    part=0
    for array; do
        part=$((part + 1))
        table "$array" | sed "s/^/$part,/"
    done | awk -F, '
        function near(a, b) { return a - b < 1e-12 && b - a < 1e-12 }
        function wrong(text) { print text ": " $0; bad = 1; exit 1 }
        { part = $1; i = $2; row = $3 }
        '"$program" >"$said" 2>&1
    result $? "families: $name"
}

# --- the two formats ---
# doubles FILE -- the numbers of a NPY file, one a line
doubles() {
    tail -c +129 "$1" | od -A n -v -t "$2" -w8 | tr -d ' '
}
make curve --count 5 --controls 4-8 --points 3-9
for array in knots controls points; do
    table $array | cut -d, -f3- | tr , '\n' >wanted
    doubles set/$array/train-00000-of-00001.npy f8 | paste -d, - wanted |
        awk -F, '$1 != $2 { print; bad = 1 } END { exit bad || NR == 0 }' >"$said"
    result $? "families: CSV and NPY of $array have the same numbers"
done
table counts | cut -d, -f3- | tr , '\n' >wanted
doubles set/counts/train-00000-of-00001.npy d8 | cmp -s - wanted
result $? "families: CSV and NPY of counts have the same integers"

# --- files of single samples ---
for call in 'curve xml' 'patch ply,xml' 'scatter ply' 'mesh mesh,xml,vtu' 'thb mesh,xml,vtu'; do
    # shellcheck disable=SC2086  # a list of words
    set -- $call
    make "$1" --count 2 --test 1 --format "$2"
    [ "$(find set -name '*-00000000000000000??.*' | wc -l)" = "$((2 * $(echo "$2" | tr , '\n' | wc -l)))" ]
    result $? "families: $1: a file for each sample and format"
    if command -v python3 >/dev/null; then
        find set -name '*.xml' -o -name '*.vtu' >names
        python3 -c 'import sys, xml.dom.minidom
for name in open("names"): xml.dom.minidom.parse(name.strip())' >"$said" 2>&1
        result $? "families: $1: XML is well-formed"
    fi
done
make scatter --count 1 --points 20 --format csv,ply
{ printf 'ply\nformat ascii 1.0\nelement vertex 20\n' && printf 'property double %s\n' x y z u v &&
    echo end_header && table points | awk -F, '{ print $3, $4, $6, $3, $4 }'; } >wanted
cmp -s set/ply/train-0000000000000000000.ply wanted
result $? "families: PLY has the points of the CSV file"
# Every cell of the VTU file has its level, in the order of the CSV file; corners are on its grid.
make mesh --count 1 --cells 4 --format csv,vtu
table cells | cut -d, -f3 >wanted
sed -n '/Name="level"/,/DataArray>$/p' set/vtu/*.vtu | grep -v DataArray | cmp -s - wanted
result $? "families: VTU has the level of each cell"
sed -n '/Name="Points"/,/DataArray>$/p' set/vtu/*.vtu | grep -v DataArray >corners
table cells | awk -F, '{ n = 4 * 2 ^ $3; x = $4 / n; y = $5 / n; h = 1 / n
    print x, y, 0; print x + h, y, 0; print x + h, y + h, 0; print x, y + h, 0 }' | cmp -s corners -
result $? "families: VTU has the corners of each cell"

# coefficients FILE -- those of an XML file, a point a line
coefficients() {
    sed -n '/<coefs/,/<\/coefs>/p' "$1" | grep -v coefs
}
make curve --count 1 --format csv,xml
table controls | cut -d, -f3- | tr , ' ' >wanted
coefficients set/xml/*.xml | cmp -s - wanted
result $? "families: XML of a curve has its control points"
grep -q "<KnotVector degree=\"3\">$(table knots | cut -d, -f3 | tr '\n' ' ' | sed 's/ $//')<" set/xml/*.xml
result $? "families: XML of a curve has its knots"
# direction 0 runs fastest there, the last one in ours
make patch --count 1 --degree 2 --cells 2 --interior 9 --format csv,xml
table controls | awk -F, '{ print $2 % 4, int($2 / 4), $3, $4, $5 }' | sort -n -k 1,1 -k 2,2 |
    cut -d' ' -f3- >wanted
coefficients set/xml/*.xml | cmp -s - wanted
result $? "families: XML of a surface has its control points"
make thb --count 1 --cells 3 --levels 3 --format csv,mesh,xml
table coefficients | sort -t, -k 3,3n -k 5,5n -k 4,4n | cut -d, -f6- | tr , ' ' >wanted
coefficients set/xml/*.xml | cmp -s - wanted
result $? "families: XML of a THB surface has its coefficients, level by level"
# the boxes of level 1 cover what the active cells of level 0 leave
sed -n 's/.*<box level="1">\(.*\)<.*/\1/p' set/xml/*.xml |
    awk '{ area += ($3 - $1) * ($4 - $2) / 4 } END { print 9 - area }' >wanted
table per_level | awk -F, '$3 == 0 { print $4 }' | cmp -s - wanted
result $? "families: XML of a THB surface has the boxes of its mesh"

# --- curves ---
# The Cox-de Boor recursion as the textbooks have it, at parameters inside the domain.
for options in '--degree 3' '--degree 1 --controls 2 --parameters equal' \
    '--degree 5 --controls 6-9 --dim 3 --law walk' '--degree 2 --controls 9 --knots random'; do
    # shellcheck disable=SC2086
    make curve --count 4 --points 20 $options --noise 0
    holds "curve $options: points are sums of control points" '
        function basis(j, d, t,   left, right) {
            if (d == 0)
                return (knot[j] <= t && t < knot[j + 1]) || (t == 1 && knot[j] < 1 && knot[j + 1] == 1)
            if (knot[j + d] > knot[j])
                left = (t - knot[j]) / (knot[j + d] - knot[j]) * basis(j, d - 1, t)
            if (knot[j + d + 1] > knot[j + 1])
                right = (knot[j + d + 1] - t) / (knot[j + d + 1] - knot[j + 1]) * basis(j + 1, d - 1, t)
            return left + right
        }
        part == 1 { knots[i] = $4; controls[i] = $5; points[i] = $6 }
        part == 2 { all_knots[i, row] = $4 }
        part == 3 { dim = NF - 3; for (h = 0; h < dim; h++) control[i, row, h] = $(4 + h) }
        part == 4 {
            n = controls[i]; d = knots[i] - n - 1
            for (j = 0; j < knots[i]; j++) {
                knot[j] = all_knots[i, j]
                if (j > 0 && knot[j] < knot[j - 1]) wrong("knots")
            }
            if (row > 0 && $4 < before) wrong("parameters do not ascend")
            before = $4
            for (h = 0; h < dim; h++) {
                s = 0
                for (j = 0; j < n; j++) s += control[i, j, h] * basis(j, d, $4)
                if (!near(s, $(5 + h))) wrong("not " s)
                if ($(5 + h) != $(5 + dim + h)) wrong("noise")
            }
            seen++
        }
        END { exit bad || seen != 80 }' counts knots controls points
done
make curve --count 20 --parameters pinned --controls 4 --points 5
holds "curve: pinned parameters begin at 0 and end at 1" '
    (row == 0 && $4 != 0) || (row == 4 && $4 != 1) { wrong("end") }
    END { exit bad || NR != 100 }' points
# 4000 normal deviates: the mean is within 5 / sqrt(4000) of 0; their variance has the standard
# deviation sqrt(2 / 4000), so it is within 5 of these of 1.
make curve --count 20 --points 100 --noise 0.5
holds "curve: noise has the mean and the variance it should have" '
    { for (h = 0; h < 2; h++) { e = ($(7 + h) - $(5 + h)) / 0.5; sum += e; square += e * e } }
    END { m = sum / 4000; v = square / 4000
          exit m * m > 25 / 4000 || (v - 1) * (v - 1) > 25 * 2 / 4000 }' points

# --- scattered points ---
for surface in franke ridge peak step; do
    make scatter --count 2 --points 50 --surface $surface
    holds "scatter: $surface" '
        function franke(x, y) {
            x *= 9; y *= 9
            return 0.75 * exp(-((x - 2) ^ 2 + (y - 2) ^ 2) / 4) + \
                   0.75 * exp(-(x + 1) ^ 2 / 49 - (y + 1) / 10) + \
                   0.5 * exp(-((x - 7) ^ 2 + (y - 3) ^ 2) / 4) - \
                   0.2 * exp(-(x - 4) ^ 2 - (y - 7) ^ 2)
        }
        function tanh(x) { return (exp(x) - exp(-x)) / (exp(x) + exp(-x)) }
        function height(u, v) {
            return surface == "franke" ? franke(u, v) : \
                surface == "ridge" ? exp(-200 * (u - v) ^ 2) : \
                surface == "peak" ? exp(-100 * ((u - 0.5) ^ 2 + (v - 0.5) ^ 2)) : \
                tanh(50 * (sqrt(u * u + v * v) - 0.6))
        }
        BEGIN { surface = "'$surface'" }
        $4 < 0 || $4 >= 1 || $5 < 0 || $5 >= 1 { wrong("outside") }
        !near($6, height($4, $5)) { wrong("not " height($4, $5)) }
        END { exit bad || NR != 100 }' points
done
make scatter --count 5 --points 100 --sampling voids --voids 2-5
holds "scatter: voids are empty" '
    part == 1 { voids[i] = $5 }
    part == 2 { u[i, row] = $4; v[i, row] = $5; r[i, row] = $6; listed++ }
    part == 3 {
        for (k = 0; k < voids[i]; k++)
            if (($4 - u[i, k]) ^ 2 + ($5 - v[i, k]) ^ 2 < r[i, k] ^ 2) wrong("in a void")
        seen++
    }
    END { exit bad || seen != 500 || listed < 10 }' counts voids points
make scatter --count 1 --points 4000 --sampling graded
# u < 1/4 has the probability 1/2; 5 standard deviations of the count are 5 sqrt(4000) / 2
holds "scatter: graded points are dense at the lower left" '
    $4 < 0.25 { few++ }
    END { exit (few - 2000) ^ 2 > 25 * 1000 }' points

# --- classes ---
for dim in 1 2 5; do
    make classes --count 6 --points 30 --dim $dim --margin 0.25
    holds "classes: the separator separates, dim $dim" '
        part == 1 { for (k = 4; k <= NF; k++) w[i, k] = $k }
        part == 2 { label[i, row] = $4 }
        part == 3 {
            s = w[i, NF + 1]; size = 0
            for (k = 4; k <= NF; k++) { s += w[i, k] * $k; size += w[i, k] ^ 2 }
            if (!near(size, 1)) wrong("|w|^2 = " size)
            if (w[i, NF + 2] != 0.25) wrong("margin")
            if (s * label[i, row] < 0.25 - 1e-12) wrong("margin " s)
            if (row < 2 && !near(s * label[i, row], 0.25)) wrong("not tight: " s)
            seen++
        }
        END { exit bad || seen != 180 }' separator labels points
done
make classes --count 3 --points 40 --kind xor --margin 0.1 --noise 0.1
holds "classes: XOR" '
    part == 1 { label[i, row] = $4 }
    part == 2 && label[i, row] * $4 * $5 <= 0 { wrong("sign") }
    part == 2 && ($4 ^ 2 < 0.01 || $5 ^ 2 < 0.01) { wrong("margin") }
    END { exit bad || NR != 240 }' labels points
make classes --count 3 --points 40 --kind rings --margin 0.1
holds "classes: rings" '
    part == 1 { label[i, row] = $4 }
    part == 2 && !near(sqrt($4 ^ 2 + $5 ^ 2), label[i, row] > 0 ? 1 : 1.2) { wrong("radius") }
    END { exit bad || NR != 240 }' labels points
make classes --count 3 --points 40 --kind spirals --margin 0.1
holds "classes: spirals" '
    part == 1 { label[i, row] = $4 }
    part == 2 {
        r = sqrt($4 ^ 2 + $5 ^ 2); a = 3 * atan2(0, -1) * (r - 0.1)
        if (!near($4, label[i, row] * r * cos(a)) || !near($5, label[i, row] * r * sin(a)))
            wrong("not on the arm")
    }
    END { exit bad || NR != 240 }' labels points

# --- patches ---
for options in '--cells 1' '--degree 3 --cells 4 --neighbours 0' '--degree 1 --scale none'; do
    # shellcheck disable=SC2086
    make patch --count 3 --interior 40 --boundary 5 $options
    holds "patch $options: the boundary goes once around" '
        part == 1 { side[i, row] = $4 }
        part == 2 {
            k = side[i, row]
            if ((row < 40) != (k == 0)) wrong("label")
            if ((k == 1 && $5 != 0) || (k == 2 && $4 != 1) || (k == 3 && $5 != 1) ||
                (k == 4 && $4 != 0)) wrong("side")
            along = k == 0 ? 0 : k + (k == 1 ? $4 : k == 2 ? $5 : k == 3 ? 1 - $4 : 1 - $5)
            if (k > 0 && row > 40 && along <= before) wrong("order")
            before = along
        }
        END { exit bad || NR != 2 * 180 }' labels points
    holds "patch $options: shifted and scaled" '
        part == 1 { factor[i] = $8 }
        part == 2 {
            for (h = 4; h <= 6; h++) {
                if (!((i, h) in low) || $h < low[i, h]) low[i, h] = $h
                if (!((i, h) in high) || $h > high[i, h]) high[i, h] = $h
            }
        }
        END {
            for (i = 0; i < 3; i++) {
                most = 0
                for (h = 4; h <= 6; h++) {
                    if (!near(low[i, h], 0)) bad = 1
                    if (high[i, h] > most) most = high[i, h]
                }
                if ("'"$options"'" ~ /none/ ? factor[i] != 1 : !near(most, 1)) bad = 1
            }
            exit bad
        }' transform controls
done
make patch --count 2 --interior 30 --boundary 5 --neighbours 3 --noise 0.01 --degree 1
holds "patch: bilinear points, and an edge for each of the 3 nearest" '
    part == 1 { for (h = 0; h < 3; h++) c[i, row, h] = $(4 + h) }
    part == 2 {
        for (h = 0; h < 3; h++) {
            s = (1 - $4) * ((1 - $5) * c[i, 0, h] + $5 * c[i, 1, h]) + \
                $4 * ((1 - $5) * c[i, 2, h] + $5 * c[i, 3, h])
            if (!near(s, $(6 + h))) wrong("not " s)
            x[i, row, h] = $(9 + h)
        }
    }
    part == 3 { if ($4 >= $5) wrong("order"); edge[i, $4, $5] = edge[i, $5, $4] = 1; edges++ }
    function distance(i, a, b) {
        return (x[i, a, 0] - x[i, b, 0]) ^ 2 + (x[i, a, 1] - x[i, b, 1]) ^ 2 + (x[i, a, 2] - x[i, b, 2]) ^ 2
    }
    function nearer(i, a, b,   k, count) {
        for (k = 0; k < 50; k++)
            count += k != a && distance(i, a, k) < distance(i, a, b)
        return count
    }
    END {
        for (i = 0; i < 2; i++)
            for (a = 0; a < 50; a++)
                for (b = a + 1; b < 50; b++)
                    if ((nearer(i, a, b) < 3 || nearer(i, b, a) < 3) != ((i, a, b) in edge)) bad = 1
        exit bad || edges < 150
    }' controls points edges

# --- meshes: gen count finds the same in the mesh file ---
for dim in 1 2 3; do
    for kind in diagonal boxes front scattered; do
        make mesh --count 2 --cells 4 --levels 3 --kind $kind --dim $dim --format csv,mesh
        for i in 0 1; do
            "$gen" count --mesh set/mesh/train-000000000000000000$i.mesh >counted 2>"$said"
            table per_level | awk -F, -v i=$i 'BEGIN { print "level,active_cells,functions" }
                $1 == i && $4 > 0 { print $3 "," $4 "," $5 }' | awk -F, 'NR == 1 || NF' >wanted
            awk -F, 'NR == 1 || $2 + $3 > 0' counted | cmp -s - wanted
            result $? "families: mesh $kind, dim $dim, sample $i: gen count agrees"
        done
        holds "mesh $kind, dim $dim: cells tile the box, as many as are counted" '
            part == 1 { count[i, $4] = $5 }
            part == 2 { found[i, $4]++; size[i] += 1 / (4 * 2 ^ $4) ^ '$dim' }
            END {
                for (key in count) if (count[key] != found[key] + 0) bad = 1
                exit bad || size[0] != 1 || size[1] != 1
            }' per_level cells
    done
done

# --- hierarchical geometries: sums of coefficients times what gen reference gives ---
for options in '--dim 1' '--dim 2 --kind front' '--dim 2 --basis hb --degree 3' '--dim 3 --degree 1'; do
    # shellcheck disable=SC2086
    make thb --count 1 --cells 3 --levels 3 --points 15 $options --format csv,mesh
    dim=$(echo "$options" | cut -c7)
    basis=thb
    case $options in *hb*) basis=hb ;; esac
    { echo x1,x2,x3 | cut -d, -f1-"$dim" && table points | cut -d, -f3-$((2 + dim)); } >points.csv
    "$gen" reference --mesh set/mesh/*.mesh --at points.csv --basis $basis | sed '1d; s/^/3,/' >values
    { table coefficients | sed 's/^/1,/' && table points | sed 's/^/2,/' && cat values; } |
        awk -F, -v D="$dim" -v basis=$basis '
            function near(a, b) { return a - b < 1e-12 && b - a < 1e-12 }
            $1 == 1 {
                key = $4; for (h = 0; h < D; h++) key = key "," $(5 + h)
                for (h = 0; h <= D; h++) c[key, h] = $(5 + D + h)
            }
            $1 == 2 { points++; for (h = 0; h <= D; h++) x[$3, h] = $(4 + D + h)
                      for (h = 0; h < D; h++) u[$3, h] = $(4 + h) }
            $1 == 3 {
                key = $3; for (h = 0; h < D; h++) key = key "," $(4 + h)
                if (!((key, 0) in c)) bad = 1
                for (h = 0; h <= D; h++) sum[$2, h] += $NF * c[key, h]
            }
            END {
                for (p = 0; p < points; p++)
                    for (h = 0; h <= D; h++) {
                        if (!near(sum[p, h], x[p, h])) bad = 1
                        if (basis == "thb" && h < D && !near(x[p, h], u[p, h])) bad = 1
                    }
                exit bad || points != 15
            }'
    result $? "families: thb $options: points are sums of coefficients"
done

# --- signals ---
make signal --count 40 --kind bars --height 5 --width 7 --noise 0
holds "signal: bars" '
    part == 1 { class[i] = $4; y[i] = $5; x[i] = $6 }
    part == 2 { for (k = 0; k < 7; k++)
        if ($(4 + k) != (class[i] ? k == x[i] : row == y[i])) wrong("pixel " k) }
    END { exit bad || NR != 240 }' labels clean
make signal --count 40 --kind edges --height 5 --width 7
holds "signal: edges" '
    part == 1 { class[i] = $4; y[i] = $5; x[i] = $6; seen[$4] = 1 }
    part == 2 { for (k = 0; k < 7; k++) {
        behind = class[i] < 2 ? row >= y[i] : k >= x[i]
        if ($(4 + k) != (class[i] % 2 ? !behind : behind)) wrong("pixel " k) } }
    END { exit bad || NR != 240 || !(seen[0] && seen[1] && seen[2] && seen[3]) }' labels clean
make signal --count 40 --kind shifts --height 1 --width 12
holds "signal: shifts" '
    part == 1 { class[i] = $4; x[i] = $6 }
    part == 2 { for (k = 0; k < 12; k++) {
        at = k - x[i]; wanted = at < 0 || at > 4 ? 0 : (class[i] ? 5 - at : at + 1) / 5
        if ($(4 + k) != wanted) wrong("pixel " k) } }
    END { exit bad || NR != 80 }' labels clean

# --- graphs ---
make graph --count 3 --nodes 30-40 --radius 0.25
holds "graph: edges, components, signal, labels" '
    part == 1 { nodes[i] = $4; edges[i] = $6; components[i] = $7 }
    part == 2 { for (k = 0; k < 4; k++) wave[i, row, k] = $(4 + k); waves = row + 1 }
    part == 3 {
        x[i, row] = $4; y[i, row] = $5; clean[i, row] = $6; s = 0
        for (k = 0; k < waves; k++)
            s += wave[i, k, 3] * sin(2 * atan2(0, -1) * (wave[i, k, 0] * $4 + wave[i, k, 1] * $5 + wave[i, k, 2]))
        if (!near(s, $6)) wrong("signal " s)
    }
    part == 4 { if ($4 != (clean[i, row] > 0)) wrong("label"); component[i, row] = $5
                if ($5 >= components[i]) wrong("component") }
    part == 5 { edge[i, $4, $5] = 1; found[i]++
                if (component[i, $4] != component[i, $5]) wrong("component") }
    END {
        for (i = 0; i < 3; i++) {
            for (a = 0; a < nodes[i]; a++)
                for (b = a + 1; b < nodes[i]; b++)
                    if (((x[i, a] - x[i, b]) ^ 2 + (y[i, a] - y[i, b]) ^ 2 < 0.0625) != ((i, a, b) in edge))
                        bad = 1
            if (found[i] != edges[i]) bad = 1
        }
        exit bad
    }' counts waves nodes labels edges

exit $failed
