#!/bin/bash
# A pack of equal spheres grown to .60.
# data: pack-grown
exec figures/tools/balls build/data/pack-grown/pack-0.xyz 7.1 '1 144682 aad2f5'
