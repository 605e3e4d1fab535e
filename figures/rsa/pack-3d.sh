#!/bin/bash
# A pack of spheres of two sizes.
# data: pack-3d
exec figures/tools/balls build/data/pack-3d/pack-0.xyz 7.8 '1 963c0a f0b46e 2 144682 aad2f5'
