#!/bin/bash
# Homes, leashes and neighbours of some discs that have moved.
# data: few-shaken
set -eu -o pipefail
awk -v width=9 -v chosen=40 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/near-leash.awk build/data/few-shaken/{made.,}pack-0.xyz |
  awk -v width=9 -f figures/tools/paint.awk
