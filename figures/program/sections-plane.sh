#!/bin/bash
# Spheres and a plane.
# data: few-spheres
set -eu -o pipefail
awk -v width=12.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/sections-plane.awk build/data/few-spheres/pack-0.xyz |
  awk -v width=12.6 -f figures/tools/paint.awk
