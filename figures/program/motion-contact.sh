#!/bin/bash
# Pairs that fly and grow, and when they meet.
# data: few-shaken
set -eu -o pipefail
awk -v width=12.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/motion-contact.awk build/data/few-shaken/{made.,}pack-0.xyz |
  awk -v width=12.6 -f figures/tools/paint.awk
