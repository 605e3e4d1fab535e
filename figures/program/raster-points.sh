#!/bin/bash
# The points of a raster and a shift.
# data: few-penetrable
set -eu -o pipefail
awk -v width=7 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/raster-points.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=7 -f figures/tools/paint.awk
