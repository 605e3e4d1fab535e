#!/bin/bash
# Samples of three points and their bits.
# data: few-penetrable
set -eu -o pipefail
awk -v width=11 -v samples='2.1 6.0 -0.35 6.0 3.6 -1.75 1.3 2.3 -0.25' -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/threepoint-arms.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=11 -f figures/tools/paint.awk
