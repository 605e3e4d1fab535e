#!/bin/bash
# A table, drawn by the command itself.
# data: rsa-histogram build/print/program
set -eu -o pipefail
build/bin/randpack plot build/data/rsa-histogram/histogram.tsv -o build/figures/view-plot.pdf
echo '\includegraphics[width=12.6cm]{build/figures/view-plot.pdf}'
