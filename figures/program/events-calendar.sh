#!/bin/bash
# The calendar of the first meetings of some discs.
# data: few-shaken
set -eu -o pipefail
awk -v width=13.4 -f figures/tools/colour.awk -f figures/program/pen.awk -f figures/tools/pack.awk -f figures/program/events-calendar.awk build/data/few-shaken/{made.,}pack-0.xyz |
  awk -v width=13.4 -f figures/tools/paint.awk
