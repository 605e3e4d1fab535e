#!/bin/bash
# The frame of a jammed pack.
# data: few-jammed
set -eu -o pipefail
awk -v width=7.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/order-frame.awk build/data/few-jammed/pack-0.xyz |
  awk -v width=7.4 -f figures/tools/paint.awk
