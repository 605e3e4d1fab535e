#!/bin/bash
# What is exposed of the boundaries of some superellipses.
# data: few-superellipses
set -eu -o pipefail
awk -v width=8.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/cover-arcs.awk build/data/few-superellipses/pack-0.xyz |
  awk -v width=8.4 -f figures/tools/paint.awk
