#!/bin/bash
# Superellipses that may overlap, S Fig. 5 b.
# data: penetrable-pack
set -eu -o pipefail
awk -v colours='c4e5f7 0072b2' -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk build/data/penetrable-pack/pack-0.xyz | awk -v width=8 -f figures/tools/paint.awk
