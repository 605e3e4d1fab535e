#!/bin/bash
# The spheres of the cover, cut: drawn by the command itself.
# data: pack-3d build/print/program
set -eu -o pipefail
build/bin/randpack view build/data/pack-3d/pack-0.xyz --cut z=0.5 -o build/figures/view.pdf
# As wide as it is by itself, so that its smallest words have seven points.
echo '\makebox[\textwidth]{\includegraphics[width=15.2cm]{build/figures/view.pdf}}'
