#!/bin/bash
# Discs at .70 before and after shaking: filled, where they are, by the way they have gone; outlines, where they were.
# data: pack-shaken
set -eu -o pipefail
awk -f figures/tools/colour.awk -f figures/tools/pack.awk -f figures/tools/moved.awk build/data/pack-shaken/{made.,}pack-0.xyz | awk -v width=10.6 -f figures/tools/paint.awk
