#!/bin/bash
# The first pack of the example of a propellant; the tools want lengths near 1.
# data: propellant-example
awk 'NR == 2 { match($0, /"[0-9. ]*"/); side = substr($0, RSTART + 1) / 40; sub(/"[0-9. ]*"/, "\"" side " 0 0 0 " side " 0 0 0 " side "\"") }
  NR > 2 { for (i = 2; i < 6; i++) $i /= 40 } { print }' build/data/propellant-example/pack-0.xyz |
  figures/tools/balls /dev/stdin 6.4 '1 963c0a f0b46e 2 144682 aad2f5'
