#!/bin/bash
# Superellipses with their support and gauge.
# data: few-shapes
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/shape-support.awk build/data/few-shapes/pack-0.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
