#!/bin/bash
# The cells of a pack and the spans around one of them.
# data: few-cells
set -eu -o pipefail
awk -v width=8.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/cells-spans.awk build/data/few-cells/pack-0.xyz |
  awk -v width=8.6 -f figures/tools/paint.awk
