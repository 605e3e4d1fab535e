#!/bin/bash
# Spheres by Fuller's curve, coloured by size.
# data: sizes-fuller
exec figures/tools/balls build/data/sizes-fuller/pack-0.xyz 7.6 '1 144682 aad2f5 2 0a5f4b 82dcc3 3 963c0a f0b46e' classes='2 4.5'
