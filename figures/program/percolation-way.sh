#!/bin/bash
# A cluster that goes round the box.
# data: few-penetrable
set -eu -o pipefail
awk -v width=9 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/percolation-way.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=9 -f figures/tools/paint.awk
