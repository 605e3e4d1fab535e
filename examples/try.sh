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
# The cut through the middle of the box: circles, as a micrograph shows them. And g(R), as a picture.
"$program" view "$dir/pack-0.xyz" --cut z=0.5 -o "$dir/cut.png"
"$program" plot "$dir/rdf.tsv" -o "$dir/rdf.png"
echo "$dir/cut.png shows a cut through the first pack, $dir/rdf.png g(R) with its errors. The packs are $dir/pack-*.xyz, which OVITO opens; the scene is examples/first.scene."
