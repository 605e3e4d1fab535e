#!/bin/bash
# Two superellipses in overlap: what they share, its centroid and the normals; the lattice of points with its layer; and two triangles with their forces, S Figs. 1-3.
# data: speed
set -eu -o pipefail
awk -f figures/shapes/contact.awk build/data/speed/overlap-pairs.tsv | awk -v width=13.4 -f figures/tools/paint.awk
