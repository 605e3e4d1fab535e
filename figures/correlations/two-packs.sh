#!/bin/bash
# S Figs. 7 a and b: superellipses, m = 2, without overlap (above) and with (below), at .1, .4 and .8. Few corners and a thin rim serve for pictures so small.
# data: two-pack two-pack-1 two-pack-4 two-pack-8
set -eu -o pipefail
draw() { local pack=$1; shift; awk -v joined=1 -v nodes=24 "$@" -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk "build/data/$pack"; }
thin() { awk 'BEGIN { FS = OFS = "\t" } $1 == "shape" { $5 = 0.15 } { print }'; }
up() {
  awk 'BEGIN { FS = OFS = "\t" }
    $1 == "shape" { $7 += 106 }
    $1 == "clip" && NF > 1 { $3 += 106; $5 += 106 }
    $1 == "line" { $4 += 106; $6 += 106 }
    { print }'
}
{
  printf 'window\t0\t0\t312\t206\n'
  for k in 1 4 8; do draw two-pack-$k/pack-0.xyz -v dx=$((k / 4 * 106)); done | up
  for k in 1 4 8; do draw two-pack/pack-0@0.$k.xyz -v dx=$((k / 4 * 106)) -v colours='f6d9b8 8a4b08'; done
} | thin | awk -v width=11 -f figures/tools/paint.awk
