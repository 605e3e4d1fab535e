#!/bin/bash
# The cover: the pack of pack-3d.scene.
# data: pack-3d
exec figures/tools/balls build/data/pack-3d/pack-0.xyz 10.8 '1 963c0a f0b46e 2 144682 aad2f5'
