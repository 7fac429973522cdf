#!/bin/sh
# page_check_test.sh -- page_test.py fails when it should: a small good page passes, and with one
# thing broken at a time exactly the question about it fails, and says what is wrong.
set -u

tests=$(cd "$(dirname "$0")" && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/out
# shellcheck source=tests/result.inc
. "$tests/../result.inc"
cd "$place" || exit 1

cat >good.html <<'END_OF_PAGE'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Good</title>
<link rel="icon" href="data:,">
<style>
body { color: #222; background: #fff; margin: 1rem; }
main p { max-width: 35rem; }
nav { position: sticky; top: 0; width: 10rem; }
.wide { overflow-x: auto; }
.wide div { width: 2000px; }
a { color: #15558a; }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #222; } a { color: #8cbdea; } }
</style>
</head>
<body>
<nav><a href="#one">One</a></nav>
<main>
<h2 id="one"><a href="#one">One</a></h2>
<p>A long text that goes on for some lines, as it says the same thing again and again, and then once more,
and that not even in other words, but in the same ones: a long text that goes on for some lines, as it says the same
thing again and again, and then once more, and that not even in other words, but in the same ones. It is a long text that
goes on for some lines, as it says the same thing again and again, and then once more, and that not even in other
words, but in the same ones.</p>
<img alt="a dot" src="data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/%3E">
<p>It is <math><mi>x</mi></math>, see <a href="https://example.org/">there</a>.</p>
<div class="wide"><div>wide, but it scrolls</div></div>
<details class="answer"><summary>Answer</summary><p>folded</p></details>
<div style="height: 4000px"></div>
</main>
</body>
</html>
END_OF_PAGE

# page NAME SCRIPT -- the good page with something broken
page() {
    sed "$2" good.html >"$1.html"
    cmp -s good.html "$1.html" && echo "not ok - page_test: $1 is not broken"
}

page script 's|</main>|<script>var a = 1;</script>&|'
page title 's|<title>Good|<title>|'
page twice 's|<p>It|<p id="one">It|'
page link 's|href="#one">One</a></nav>|href="#two">One</a></nav>|'
page file 's|https://example.org/|../lib/mesh.h|'
page picture 's|xmlns=|nothing=|'
page alt 's|alt="a dot"|alt=""|'
page heading 's|<h2 id="one"><a href="#one">One</a>|<h2 id="one">One|'
page mark 's|<p>It is|<p>[It]{.ours} is|'
page wide 's|^.wide { overflow-x: auto; }||'
page answer 's|<p>folded|<p style="min-width: 900px">folded|'
page formula 's|<math>|<math style="display: inline-block; height: 1px">|'
page small 's|<p>folded|<p style="font-size: 9px">folded|'
page lines 's|max-width: 35rem|max-width: 90rem|; s|<p>A|<p style="max-width: 55rem">A|'
page contents 's|position: sticky|position: static|'
page light 's|a { color: #15558a|a { color: #9ab|'
page bright '/prefers-color-scheme/d'
page dark 's|color: #ddd|color: #555|'
page request 's|<title>|<link rel="stylesheet" href="https://example.org/a.css">&|'
page console 's|</main>|<img alt="none" src="data:image/png,none" onerror="console.error(1)">&|'

timeout 500 python3 "$tests/page_test.py" ./*.html >all
status=$?
[ "$status" = 1 ]
result $? "page_test: exits 1 if something is not ok"
grep -F ' - ./good.html: ' all >out
! grep -q '^not ok' out && [ "$(grep -c '^ok' out)" -gt 20 ]
result $? "page_test: a good page passes"

# caught NAME TEXT ... -- all that is not ok with page NAME are questions with these texts
caught() {
    name=$1
    grep -F "not ok - ./$name.html: " all >out
    shift
    wrong=0
    [ -s out ] || wrong=1
    for text; do
        grep -qF -e "$text" out || wrong=1
        grep -vF -e "$text" out >rest
        mv rest out
    done
    [ -s out ] && wrong=1
    result "$wrong" "page_test: $name"
}

caught script 'no script is in the page: <script>'
caught title 'the page has a title'
caught twice 'address is there twice: one'
caught link 'leads into the page or out to the web: #two'
caught file 'leads into the page or out to the web: ../lib/mesh.h'
caught picture 'every picture is there and says what it shows: a dot'
caught alt 'every picture is there and says what it shows: no alt'
caught heading 'links to it: One'
caught mark "marks is left: [It]{.ours} is"
caught wide 'nothing is wider than the page, 360' 'wider than the page, 768' 'wider than the page, 1440'
caught answer 'nothing is wider than the page, 360' 'wider than the page, 768'
caught formula 'has a height and a width, 360' 'has a height and a width, 768' 'has a height and a width, 1440'
caught small 'smaller than 12 pixels, 360' 'smaller than 12 pixels, 768' 'smaller than 12 pixels, 1440'
caught lines 'lines are not too long: A long text'
caught contents 'the contents scroll away'
caught light 'contrast is enough in the light:'
caught bright 'dark mode is dark: the paper is light'
caught dark 'contrast is enough in the dark:'
caught request 'no request leaves the page: https://example.org/a.css' 'the console is silent'
caught console 'the console is silent' 'every picture is there'

exit "$failed"
