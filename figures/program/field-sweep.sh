#!/bin/bash
# One sweep of the radial field: the discs by rank, and what pushes what.
# data: few-gravity
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/field-sweep.awk build/data/few-gravity/pack-0@{1,2}.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
