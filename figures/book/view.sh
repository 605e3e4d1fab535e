#!/bin/bash
# The spheres of the cover, cut: drawn by the command itself.
# data: pack-3d build/bin/randpack
set -eu -o pipefail
build/bin/randpack view build/data/pack-3d/pack-0.xyz --cut z=0.5 -o build/figures/view.pdf
echo '\includegraphics[width=11.5cm]{build/figures/view.pdf}'
