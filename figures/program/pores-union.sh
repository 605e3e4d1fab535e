#!/bin/bash
# Where a disc fits between the discs of a pack.
# data: few-rsa
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/pores-union.awk build/data/few-rsa/pack-0.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
