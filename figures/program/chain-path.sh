#!/bin/bash
# A straight chain of events.
# data: few-shaken
set -eu -o pipefail
awk -v width=9.6 -v start=29 -v length_of=4.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/chain-path.awk build/data/few-shaken/pack-0.xyz |
  awk -v width=9.6 -f figures/tools/paint.awk
