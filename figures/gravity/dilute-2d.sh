#!/bin/bash
# Discs by gravity, diluted by moves of three ranges, coloured by the distance of the nearest other surface.
# data: dilute-2d
set -eu -o pipefail
runs='surfaces@0 surfaces@1 centres@1'
cut() { awk -f figures/tools/pack.awk -f figures/tools/cut.awk "build/data/dilute-2d/pack-0@$1.xyz"; }
moves=$(for r in $runs; do awk -f figures/tools/columns.awk get=value "where=quantity=moves@$r" build/data/dilute-2d/summary.tsv; done)
awk -v moves="$(echo $moves)" -f figures/tools/colour.awk -f figures/tools/diluted.awk <(cut surfaces@0) <(cut surfaces@1) <(cut centres@1) |
  awk -v width=13.8 -f figures/tools/paint.awk
