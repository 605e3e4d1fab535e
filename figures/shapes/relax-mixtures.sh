#!/bin/bash
# Triangles, squares, hexagons and squares with round corners, of two sizes, freed of overlap.
# data: relax-mixtures
set -eu -o pipefail
awk -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/shapes.awk build/data/relax-mixtures/pack-0.xyz | awk -v width=7.5 -f figures/tools/paint.awk
