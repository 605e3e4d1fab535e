#!/bin/bash
# Squares from the cores of two packs of discs by gravity: coarse ones added, and marked. Discs without a contact are lighter.
# data: gravity-2d gravity-2d-mark
set -eu -o pipefail
cut() { awk -v half=24 -f figures/pack.awk -f figures/cut.awk "build/data/$1/pack-0.xyz"; }
awk -v half=24 -f figures/colour.awk -f figures/squares.awk <(cut gravity-2d) <(cut gravity-2d-mark) | awk -v width=13.2 -f figures/paint.awk
