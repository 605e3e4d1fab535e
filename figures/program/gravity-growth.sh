#!/bin/bash
# A pack by gravity as it grows.
# data: few-growth
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/gravity-growth.awk build/data/few-growth/pack-0@{1.05,1.7,3}.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
