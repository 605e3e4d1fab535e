#!/bin/bash
# A disc, the window of its centre and what of it is free.
# data: few-shaken
set -eu -o pipefail
awk -v width=8.4 -v chosen=40 -v way=172 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/shake-trial.awk build/data/few-shaken/pack-0.xyz |
  awk -v width=8.4 -f figures/tools/paint.awk
