#!/bin/bash
# Strata of a law of sizes.
# data: few-sizes
set -eu -o pipefail
awk -v width=9 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/sizes-strata.awk build/data/few-sizes/pack-0.xyz |
  awk -v width=9 -f figures/tools/paint.awk
