#!/bin/bash
# examples/try.sh PROGRAM DIR: make the first pack, and show it: its numbers, its g(R) in letters, and a picture of a slice.
set -eu -o pipefail
program=$1 dir=$2
"$program" run examples/first.scene --out "$dir"
printf '\n%-20s %14s  %s\n' quantity value 'standard error'
awk -F'\t' '$1 ~ /^(fraction|number|min_gap|contact|Z|coordination)$/ { printf "%-20s %14.6g  %.2g\n", $1, $2, $3 }' "$dir/summary.tsv"
gnuplot -e "table = '$dir/rdf.tsv'" - <<'END'
set terminal dumb 79 20
set datafile separator tab
set key off
set xlabel "R = r/a"
set title "g(R)"
plot [2:6] table using 1:2 with lines
END
# The cut through the middle of the box: circles, as a micrograph shows them.
awk 'NR == 2 { split($0, part, /["= ]+/); half = part[2] / 2 } NR > 2 { d = $4 - half; if (d * d < $5 * $5) print $2, $3, sqrt($5 * $5 - d * d) }' \
  "$dir/pack-0.xyz" > "$dir/cut.txt"
gnuplot -e "table = '$dir/cut.txt'; out = '$dir/cut.png'" - <<'END'
set terminal pngcairo size 600,600
set output out
set size ratio -1
set margins 0, 0, 0, 0
unset border; unset tics; unset key
set offsets 1, 1, 1, 1
plot table using 1:2:3 with circles fc rgb "#9cc3e0" fs solid 1 border lc rgb "#0072b2"
END
echo "$dir/cut.png shows a cut through the first pack. The packs are $dir/pack-*.xyz, which OVITO opens; the scene is examples/first.scene."
