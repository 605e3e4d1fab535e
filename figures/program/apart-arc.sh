#!/bin/bash
# The search for a direction that parts two triangles.
# data: few-triangles
set -eu -o pipefail
awk -v width=12.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/apart-arc.awk build/data/few-triangles/pack-0.xyz |
  awk -v width=12.6 -f figures/tools/paint.awk
