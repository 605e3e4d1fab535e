#!/bin/bash
# A pack of discs at saturation, with the images that reach over the sides.
# data: pack-2d
set -eu -o pipefail
awk -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/discs.awk build/data/pack-2d/pack-0.xyz | awk -v width=12.6 -f figures/tools/paint.awk
