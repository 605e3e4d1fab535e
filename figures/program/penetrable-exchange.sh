#!/bin/bash
# An exchange of a grain.
# data: few-penetrable
set -eu -o pipefail
awk -v width=10.4 -v g=5 -v tx=7.6 -v ty=5.6 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/penetrable-exchange.awk build/data/few-penetrable/pack-0.xyz |
  awk -v width=10.4 -f figures/tools/paint.awk
