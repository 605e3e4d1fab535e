#!/bin/bash
# tests/check-optimum.sh: figures/propellant/propellant-optimum.awk on curves whose maxima, line and layer are known.
. tests/tell.sh
# map [SIZE PLACE STEP]: five sizes, cubics in X with the maximum 0.85 - 0.4 R at X = 0.7 + 0.1 R; one point moved.
map() {
  awk -v size="${1:-0}" -v place="${2:-0}" -v step="${3:-0}" 'BEGIN { OFS = "\t"; OFMT = "%.15g"
    print "# made up"; print "species.[1].radius", "species.[0].volume", "number", "number_err", "fraction", "fraction_err"
    n = split("0.6 0.5 0.3 0.2 0.15", r, " "); m = split("1 1.5 2 2.5 3 4 9", p, " ")
    for (i = 1; i <= n; i++) for (j = 1; j <= m; j++) { u = p[j] / (1 + p[j]) - 0.7 - 0.1 * r[i]
      print r[i], p[j], 2000, 0, 0.85 - 0.4 * r[i] - 0.9 * u * u - u * u * u + (r[i] == size && j == place ? step : 0), 0.002 } }' > "$tmp/sweep.tsv"
  printf 'quantity\tvalue\tstandard_error\nfraction@0.03@2000\t0.64\t0.001\n' > "$tmp/one.tsv"
  awk -f figures/propellant/propellant-optimum.awk "$tmp/one.tsv" "$tmp/sweep.tsv" > "$tmp/optimum.tsv"
}
# near ROW COLUMN VALUE TOLERANCE
near() { awk -F'\t' -v r="$1" -v c="$2" -v v="$3" -v t="$4" '$1 == r { d = $c - v; good = d * d <= t * t } END { exit !good }' "$tmp/optimum.tsv"; }
row() { awk -F'\t' -v r="$1" -v c="$2" '$1 == r { print $c }' "$tmp/optimum.tsv"; }
# The error of a maximum is that of its five points, each moved by a little.
moved() {
  map; local x; x=$(row "$1" 2); local e; e=$(row "$1" 3); local sum=0
  for place in 2 3 4 5 6; do
    map 0.2 $place 1e-5
    sum=$(awk -v s="$sum" -v x="$x" -v y="$(row "$1" 2)" 'BEGIN { printf "%.12g", s + ((y - x) / 1e-5 * 0.002) ^ 2 }')
  done
  awk -v s="$sum" -v e="$e" 'BEGIN { exit !(s > 0 && (sqrt(s) / e - 1) ^ 2 < 1e-4) }'
}
map
tell 'the share of a known maximum' near X@0.2 2 0.72 1e-9
tell 'a known maximum' near fraction@0.15 2 0.79 1e-9
tell 'the line through the maxima' near slope 2 0.4 1e-8
tell 'its end at size zero' near fraction@0 2 0.85 1e-8
tell 'Furnas of one size' near furnas 2 0.8704 1e-12
tell 'coarse spheres of the pack: 2000 at 9 to 1, ratio 5' near coarse@0.2@9 2 134 0
tell 'the error of the share by moved points' moved X@0.2
tell 'the error of the maximum by moved points' moved fraction@0.2
# With the layer 0.1 the fraction is 0.64/(1 - X (1 - 0.64 (1 + 0.6 R))).
layered() {
  awk 'BEGIN { OFS = "\t"; OFMT = "%.15g"; print "species.[1].radius", "species.[0].volume", "number", "fraction", "fraction_err"
    n = split("0.3 0.2 0.15", r, " "); m = split("1 1.5 2 2.5 3", p, " ")
    for (i = 1; i <= n; i++) for (j = 1; j <= m; j++) { X = p[j] / (1 + p[j])
      print r[i], p[j], 2000, 0.64 / (1 - X * (1 - 0.64 * (1 + 0.6 * r[i]))), 0.002 } }' > "$tmp/sweep.tsv"
  awk -f figures/propellant/propellant-optimum.awk "$tmp/one.tsv" "$tmp/sweep.tsv" > "$tmp/optimum.tsv"
  near layer@0.2@2.5 2 0.1 1e-9 && near layer 2 0.1 1e-9
}
tell 'the layer that a pack was made with' layered
exit $failed
