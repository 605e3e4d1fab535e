#!/bin/bash
# The box, its copies and nearest images.
# data: few-shaken
set -eu -o pipefail
awk -v width=8 -v c=5 -v others='2 6 7' -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/box-images.awk build/data/few-shaken/pack-0.xyz |
  awk -v width=8 -f figures/tools/paint.awk
