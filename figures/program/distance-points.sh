#!/bin/bash
# Points and the nearest boundaries.
# data: few-superellipses
set -eu -o pipefail
awk -v width=7.6 -v points='4.1 2.2 1.2 5.0 3.3 4.6 3.1 0.6 6.35 5.6 4.75 5.2' -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/distance-points.awk build/data/few-superellipses/pack-0.xyz |
  awk -v width=7.6 -f figures/tools/paint.awk
