#!/bin/bash
# Squares from the cores of two packs of discs by gravity: coarse ones added, and marked. Discs without a contact are lighter.
# data: gravity-2d gravity-2d-mark
set -eu -o pipefail
cut() { awk -v half=24 -f figures/tools/pack.awk -f figures/tools/cut.awk "build/data/$1/pack-0.xyz"; }
awk -v half=24 -f figures/tools/colour.awk -f figures/tools/squares.awk <(cut gravity-2d) <(cut gravity-2d-mark) | awk -v width=13.2 -f figures/tools/paint.awk
