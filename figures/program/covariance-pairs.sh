#!/bin/bash
# A point of a boundary and the boundary near it.
# data: few-penetrable
set -eu -o pipefail
awk -v width=8.4 -v chosen=5 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/covariance-pairs.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=8.4 -f figures/tools/paint.awk
