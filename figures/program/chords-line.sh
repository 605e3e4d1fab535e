#!/bin/bash
# A line and its chords.
# data: few-penetrable
set -eu -o pipefail
awk -v width=12 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/chords-line.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=12 -f figures/tools/paint.awk
