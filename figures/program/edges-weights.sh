#!/bin/bash
# A pair near the wall of a window, by three treatments.
# data: few-shaken
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/edges-weights.awk build/data/few-shaken/pack-0.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
