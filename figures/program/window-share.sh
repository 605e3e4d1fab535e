#!/bin/bash
# The share of a circle that lies in a window.
# data: few-shaken
set -eu -o pipefail
awk -v width=6.6 -v c=7 -v reach=4.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/window-share.awk build/data/few-shaken/pack-0.xyz |
  awk -v width=6.6 -f figures/tools/paint.awk
