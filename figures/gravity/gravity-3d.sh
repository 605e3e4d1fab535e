#!/bin/bash
# A ball of spheres of two sizes by gravity, an octant cut out towards the eye; pale outside, and each plane of the cut has its light.
# data: gravity-3d
pack=build/data/gravity-3d/pack-0.xyz
rim=$(sed -n '2s/.* open=\([0-9.]*\) .*/\1/p' $pack)
exec figures/tools/balls $pack 9.2 "10 7c8f9f bad5eb 11 1e3d56 538cba 12 254c6c 61a8e1 13 2b5a7f 6cc0ff
  20 a18774 eecaaf 21 5b3011 c2763c 22 713d15 eb8b44 23 854719 ff9f4b" cut="$rim"
