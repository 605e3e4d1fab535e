# All pairs nearer than 1.5 at unit density: distances computed, and seconds, against N.
# data: build/data/speed/summary.tsv data/bench-seconds.tsv
rows(m) = recorded("task=neighbours;method=".m)
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set mxtics 1; set mytics 1
set xlabel "$N$"
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.97 spacing 0.14
unset key
set xrange [20:2e6]; set yrange [100:1e12]; set xtics 100,10; set ytics 100,100
set ylabel "distances computed" offset 2.2,0
set label 1 ink(Plain, "all pairs") at 3e3,5e8 right; set label 2 ink(Ours, "cells, ours; ").ink(5, "plain") at 2e6,4e4 right
set label 3 ink(Guide, "pairs found") at 2e6,3e3 right
plot "build/data/speed/neighbours.tsv" using "N":"all pairs" with lines lt Plain, "" using "N":"cells as wide as the reach" with lines lt 5, \
  "" using "N":"ours" with lines lt Ours, "" using "N":"pairs found" with lines lt Guide
unset label
set xrange [20:3e5]; set yrange [1e-6:100]; set xtics 100,10; set ytics 1e-6,100
set ylabel "seconds" offset 2.2,0
set label 1 ink(Plain, "all pairs") at 1.5e3,0.3 right; set label 2 ink(Ours, "ours") at 3.5e4,4e-4
set label 3 ink(5, "plain cells") at 2.9e5,4.5 right
plot rows("plain_all") using "size":"seconds":"spread" with yerrorlines lt Plain, rows("plain_lists") using "size":"seconds":"spread" with yerrorlines lt 5, \
  rows("ours") using "size":"seconds":"spread" with yerrorlines lt Ours
unset multiplot
