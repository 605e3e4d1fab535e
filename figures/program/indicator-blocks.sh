#!/bin/bash
# Blocks inside, outside and undecided.
# data: few-penetrable
set -eu -o pipefail
awk -v width=7.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/indicator-blocks.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=7.4 -f figures/tools/paint.awk
