#!/bin/bash
# tests/check-figures.sh: columns by name, and that a figure which shows less than it says is refused: on made-up tables.
. tests/tell.sh
root=$PWD
table() { printf "$1" | tr ' ' '\t' > "$tmp/$2"; }
columns() { awk -f figures/tools/columns.awk "$@" 2>&1; }
is() { local want=$1; shift; local got; got=$("$@" | tr '\t' ' '); [ "$got" = "$(printf "$want")" ] || { echo "wanted: $want"; echo "got: $got"; return 1; }; }
says() { local want=$1 got; shift; if got=$("$@" 2>&1); then echo "succeeded: $*"; return 1; fi; grep -qF -- "$want" <<< "$got" || { echo "wanted: $want"; echo "got: $got"; return 1; }; }

# ---- rows and columns
table '# made up\nR g g_err kind\n1 2.5 3 a\n2 3.5 4 b\n3 7 0 a\n4 9 1 bb\n' one.tsv
table 'g_err R g\n.5 4 12\n.25 2 13\n' two.tsv
table 'quantity value standard_error\nX@0.1 5 .1\nX@1e+06 7 .2\nY@0.1 3 .3\nlast 4 nan\n' summary.tsv
tell 'rows on conditions' is 'R g g_err kind\n3 7 0 a' columns 'where=kind=a;R>1;g<8' "$tmp/one.tsv"
tell 'a number is compared as one' is '9' columns get=g where=R=4.0 "$tmp/one.tsv"
tell 'a star stands for anything' is '3.5 9' columns get=g 'where=kind=b*' "$tmp/one.tsv"
tell 'tables side by side, by the first column wherever it stands' is 'R g g_err kind g_err_2 R_2 g_2\n2 3.5 4 b .25 2 13\n4 9 1 bb .5 4 12' \
  columns by=R "$tmp/one.tsv" "$tmp/two.tsv"
tell 'rows taken together: means, and errors of means' is 'R g g_err kind\n1.5 3 2.5 nan\n3.5 8 0.5 nan' columns bin=2 "$tmp/one.tsv"
tell 'quantities by pattern' is 'quantity value standard_error at quantity_2 value_2 standard_error_2 at_2\nX@0.1 5 .1 0.1 Y@0.1 3 .3 0.1' \
  columns 'of=X@*' "$tmp/summary.tsv" 'of=Y@*' "$tmp/summary.tsv"
tell 'a column that a condition lacks' says 'no column h' columns 'where=h=1' "$tmp/one.tsv"
tell 'a column that is to be had' says 'no column h' columns get=h "$tmp/one.tsv"
tell 'a column to join by' says 'no column kind' columns by=kind "$tmp/one.tsv" "$tmp/two.tsv"
tell 'a quantity that was not measured' says 'no row for quantity=Z' columns get=value where=quantity=Z "$tmp/summary.tsv"
tell 'an empty table' says 'no table' columns /dev/null
by_number() {
  ! sed -E 's/"[^"]*"//g; s/every [^ ]*//g' figures/*/*.gp | grep -nE '\$[1-9]|using [0-9]|column\([0-9]|:[0-9]+ +with'
}
tell 'no figure reads a column by its number' by_number

# ---- what is refused
draw() { { echo "t = '$tmp/one.tsv'"; cat; } > "$tmp/figure.gp"; figures/tools/draw "$tmp/figure.gp" "$tmp/figure.tex"; }
good='unset key; set xrange [0:5]; set yrange [0:10]; set multiplot layout 1,2
plot t using "R":"g":"g_err" with yerrorbars title "bars", 3 with lines, t using "R":(low("g")):(high("g")) with filledcurves
set logscale y; set yrange [1:10]
plot t using "R":"g":"kind" with labels offset 1,1, t using "R":"g":(0.1) with circles, t using "R":"g":(1):(1) with vectors
unset multiplot'
drawn() { draw <<< "$good" && [ -s "$tmp/figure.tex" ] && [ -s "$tmp/figure.pdf" ]; }
tell 'a figure of two panels is drawn' drawn
# Thinned, it has no state that changes nothing, its discs are ends of lines, and TeX can read it.
thinned() {
  perl -MCompress::Zlib -0777 -ne 's/.*?\nstream\n(.*?)\nendstream.*/$1/s; my $t = uncompress($_) // "";
    exit !($t =~ /^(\S+ \S+) m\n\1 l$/m && $t !~ /1 0 0 1 0 0 cm/)' "$tmp/figure.pdf" &&
    pdflatex -draftmode -halt-on-error -interaction=batchmode -output-directory="$tmp" \
      "\\documentclass{article}\\usepackage{graphicx}\\begin{document}\\includegraphics{$tmp/figure.pdf}\\end{document}" > /dev/null
}
tell 'and has no byte that says nothing' thinned
# refused WORDS SED: the figure, changed so, is refused with the words, and nothing is left.
refused() {
  says "$1" draw <<< "$(sed "$2" <<< "$good")" && [ ! -e "$tmp/figure.tex" ]
}
tell 'a line outside the axes' refused 'panel 1, element 2 has no point inside its axes: "3"' 's/^\(plot.*\) 3 with/\1 13 with/;s/13 with lines/13 with lines title "3"/'
tell 'bars outside' refused 'panel 1, element 1 has no point inside its axes: "bars"' 's/"R":"g":"g_err"/"R":(column("g") + 20):"g_err"/'
tell 'an area outside' refused 'panel 1, element 3' 's/(high("g")) with/(high("g") + 90) with/;s/(low("g"))/(low("g") + 90)/'
tell 'labels outside' refused 'panel 2, element 1' 's/"R":"g":"kind"/"R":(column("g") + 20):"kind"/'
tell 'circles outside' refused 'panel 2, element 2' 's/"R":"g":(0.1)/(column("R") + 9):"g":(0.1)/'
tell 'arrows from outside' refused 'panel 2, element 3' 's/"R":"g":(1)/"R":(-1):(1)/'
tell 'nothing that is a number' refused 'panel 1, element 1' 's/"R":"g":"g_err"/"R":(NaN):"g_err"/'
tell 'a table without the column' refused 'no column with header "h"' 's/"R":"g":"g_err"/"R":"h":"g_err"/'
tell 'a table without the column, in a formula' refused 'no column with header "h"' 's/high("g")/high("h")/'
tell 'a table that is not there' refused 'Cannot find or open file' 's/3 with lines/"none.tsv" using "R":"g" with lines/'
tell 'a filter that fails' refused 'no column h' "s|3 with lines|columns('where=h=3 '.t) using \"R\":\"g\" with lines|"
tell 'an axis without extent' refused 'empty y range' 's/\[1:10\]/[1:1]/'
tell 'a command of LaTeX that became a tab' refused 'a tab in a label' 's/"R":"g":"kind"/"R":"g":("\\\\ttfamily ".stringcolumn("kind"))/'
tell 'no plot at all' refused 'plots nothing' '/^plot/d'

# The two that were broken: tables of shaken packs have two columns more than others.
mkdir -p "$tmp/build/data/first-peak" "$tmp/build/figures" && ln -s "$root/figures" "$tmp/figures"
for rule in retry metropolis; do for c in 0.55 0.575 0.6; do
  awk -v c=$c 'BEGIN { OFS = "\t"; print "R", "g", "g_err", "change", "change_err"
    for (R = 2.01; R < 4.5; R += 0.02) print R, 1 + 20 * c * exp(-9 * (R - 2)), 0.02, -0.5, 0.01 }' > "$tmp/build/data/first-peak/shaken.rdf@$rule@$c.tsv"
  printf 'shaken.contact@%s@%s\t%s\t0.1\n' $rule $c "$(awk -v c=$c 'BEGIN { print 1 + 20 * c }')"
done; done | sed '1iquantity\tvalue\tstandard_error' > "$tmp/build/data/first-peak/summary.tsv"
extrapolation() { (cd "$tmp" && sed "$1" "$root/figures/shake/extrapolation.gp" > figure.gp && figures/tools/draw figure.gp figure.tex); }
tell 'a figure of two tables with more columns than three' extrapolation ''
tell 'with the columns that it read when it was broken' says 'panel 1, element 1' extrapolation 's/"g_2"/"change"/;s/"g_err_2"/"change_err"/'
sed -i 's/g_err/error/' "$tmp"/build/data/first-peak/*@0.6.tsv
tell 'and with one that is called otherwise' says 'no column with header "g_err"' extrapolation ''

# ---- drawings of packs
# pack X Y Z R ...: spheres in a box of 20
pack() {
  { echo "$(($# / 4))"; echo 'Lattice="20 0 0 0 20 0 0 0 20" Properties=species:S:1:pos:R:3:radius:R:1 pbc="T T T"'
    while [ $# -gt 0 ]; do echo "a $1 $2 $3 $4"; shift 4; done; } > "$tmp/pack.xyz"
}
balls() { figures/tools/balls "$tmp/pack.xyz" 5 '1 102030 a0b0c0' | grep -c ' Do '; }
# Towards the eye is (sin .6 cos .5, cos .6 cos .5, sin .5).
pack 10 10 10 2 7.0 5.7 7.1 1 7.0 5.7 4.5 1
tell 'a sphere behind a larger one is left out, and one beside it is not' is 2 balls
pack 10 10 10 2 13 14.3 12.9 1
tell 'one before a larger one is drawn, and so is that' is 2 balls
# Of a row of spheres behind a plate of others each is seen through the gaps: nothing that is seen is left out.
gaps() {
  awk -v OFS='\t' 'BEGIN { for (i = -8; i <= 8; i++) for (j = -8; j <= 8; j++) print 100, 1.01 * i, 1.01 * j, 0.5; print 50, 0.505, 0.505, 0.2; print 40, 0, 0, 0.3 }' |
    awk -F'\t' -f figures/tools/seen.awk | cut -f1 | sort -g | uniq -c | awk '{ printf "%s ", $2 }'
}
tell 'what shows through a gap is kept, what is covered is not' is '50 100 ' gaps
# slit X Y: between two discs, along y or x
slit() { printf '%s\n' "100 -$1 -$2 1" "100 $1 $2 1" '50 0 0 0.05' "40 $1 $2 0.5" | tr ' ' '\t' | awk -F'\t' -f figures/tools/seen.awk | cut -f1 | tr '\n' ' '; }
tell 'and what shows through a slit of a fiftieth' is '100 100 50 ' slit 1.01 0
tell 'and through one that lies' is '100 100 50 ' slit 0 1.01
# clip X: a shape there, in a clip from 0 to 1
clip() { printf '%s\n' 'window 0 0 4 1' 'outline S -1 -1 1 -1 0 1' 'clip 0 0 1 1' "shape S 102030 405060 0.4 $1 0.5 0.2 1 0" clip 'disc 102030 3 0.5 0.3' | tr ' ' '\t' | awk -v width=5 -f figures/tools/paint.awk; }
shown() { clip 0.5 | grep -c ' Do '; }
tell 'a shape in a clip is drawn' is 1 shown
tell 'one that the clip hides is no drawing' says 'lies outside it' clip 2.5
pack
tell 'a pack without particles is no drawing' says 'nothing is drawn' figures/tools/balls "$tmp/pack.xyz" 5 '1 102030 a0b0c0'
sed -i 's/radius:R:1/diameter:R:1/' "$tmp/pack.xyz"; echo 'a 1 1 1 1' >> "$tmp/pack.xyz"
tell 'a pack without radii' says 'no species, pos or radius' figures/tools/balls "$tmp/pack.xyz" 5 '1 102030 a0b0c0'
# The same bytes by another awk.
if command -v mawk > /dev/null && command -v gawk > /dev/null; then
  pack 10 10 10 2 13 14.3 12.9 1 3 4 5 1.7
  with() { mkdir -p "$tmp/$1"; ln -sf "$(command -v "$1")" "$tmp/$1/awk"; PATH=$tmp/$1:$PATH figures/tools/balls "$tmp/pack.xyz" 5 '1 102030 a0b0c0'; }
  tell 'mawk and gawk draw the same bytes' cmp <(with mawk) <(with gawk)
fi
exit $failed
