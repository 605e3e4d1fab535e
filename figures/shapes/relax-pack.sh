#!/bin/bash
# Shapes freed of overlap, S Fig. 4 c: pentagons and superellipses side by side.
# data: relax-pack relax-pack-superellipses
set -eu -o pipefail
draw() { awk "$@" -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk "build/data/$scene/pack-0.xyz"; }
{ scene=relax-pack draw -v wide=2.06; scene=relax-pack-superellipses draw -v joined=1 -v dx=106 -v colours='f6d9b8 8a4b08'; } | awk -v width=13.4 -f figures/tools/paint.awk
