#!/bin/bash
# A finite pack, its core, and the reach of one centre.
# data: few-finite
set -eu -o pipefail
awk -v width=7.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/core-centres.awk build/data/few-finite/pack-0.xyz |
  awk -v width=7.4 -f figures/tools/paint.awk
