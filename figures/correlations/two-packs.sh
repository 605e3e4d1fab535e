#!/bin/bash
# S Figs. 7 a and b: superellipses, m = 2, without overlap (above) and with (below), at .1, .4 and .8. Every eighth corner serves for pictures so small.
# data: two-pack two-pack-1 two-pack-4 two-pack-8
set -eu -o pipefail
draw() { local pack=$1; shift; awk -v joined=1 "$@" -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk "build/data/$pack"; }
coarse() { awk 'BEGIN { FS = OFS = "\t" } $1 == "path" { s = $1 OFS $2 OFS $3 OFS 0.15; for (i = 5; i < NF; i += 16) s = s OFS $i OFS $(i + 1); $0 = s } { print }'; }
up() {
  awk 'BEGIN { FS = OFS = "\t" }
    $1 == "path" { for (i = 6; i <= NF; i += 2) $i += 106 }
    $1 == "clip" && NF > 1 { $3 += 106; $5 += 106 }
    $1 == "line" { $4 += 106; $6 += 106 }
    { print }'
}
{
  printf 'window\t0\t0\t312\t206\n'
  for k in 1 4 8; do draw two-pack-$k/pack-0.xyz -v dx=$((k / 4 * 106)); done | up
  for k in 1 4 8; do draw two-pack/pack-0@0.$k.xyz -v dx=$((k / 4 * 106)) -v colours='f6d9b8 8a4b08'; done
} | coarse | awk -v width=11 -f figures/tools/paint.awk
