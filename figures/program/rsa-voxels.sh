#!/bin/bash
# Voxels that are left while discs are added, at three moments.
# data: few-rsa
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/rsa-voxels.awk build/data/few-rsa/pack-0.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
