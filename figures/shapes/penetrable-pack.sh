#!/bin/bash
# Superellipses and squares that may overlap, S Fig. 5 b.
# data: penetrable-pack penetrable-pack-squares
set -eu -o pipefail
draw() { awk "$@" -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk "build/data/$scene/pack-0.xyz"; }
{ scene=penetrable-pack draw -v nodes=40 -v colours='c4e5f7 0072b2' -v wide=2.06; scene=penetrable-pack-squares draw -v joined=1 -v dx=106 -v colours='f6d9b8 8a4b08'; } | awk -v width=13.4 -f figures/tools/paint.awk
