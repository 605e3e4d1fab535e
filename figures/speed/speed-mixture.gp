# Two sizes: candidates a pair and seconds of the counts by species; contact values; the Percus-Yevick mixture.
# data: build/data/speed/summary.tsv data/bench-seconds.tsv
set terminal cairolatex pdf size 12.6cm,11.4cm font ",10" fontscale 0.9 linewidth 1 dashlength 1.2
set output out
# N, how many times as fast as the plain program, and its error
times(l) = columns(sprintf("by=size 'where=task=partials;method=plain_sorted;case=%s' data/bench-seconds.tsv 'where=task=partials;method=ours;case=%s' data/bench-seconds.tsv", l, l))
fast(x) = column("seconds")/column("seconds_2")
fast_err(x) = fast(x)*sqrt((column("spread")/column("seconds"))**2 + (column("spread_2")/column("seconds_2"))**2)
contact(p, m, w) = columns(sprintf("'where=pair=%s;phi=0.3;method=%s;width (R) or degree=%s' build/data/speed/mixture-contact.tsv", p, m, w))
curve(l) = recorded("task=mixture;case=".l)
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set logscale xy; set mxtics 1; set mytics 1
unset key
set multiplot
set lmargin screen 0.115; set rmargin screen 0.475; set bmargin screen 0.60; set tmargin screen 0.965
set xrange [0.085:1.15]; set yrange [3:1e4]; set ytics 10,10
set xtics ("$.1$" 0.1, "$.2$" 0.2, "$.5$" 0.5, "$1$" 1); set format x "$%g$"
set xlabel "$a_2/a_1$"; set ylabel "candidates a pair counted" offset 2,0
set label ink(5, "one reach for all") at 0.2,1.6e3; set label ink(Ours, "ours") at 0.11,6.5
plot "build/data/speed/partials.tsv" using "lambda":"one reach for all" with linespoints lt 5, "" using "lambda":"ours" with linespoints lt Ours
unset label
set lmargin screen 0.64; set rmargin screen 0.985
set format x "$10^{%T}$"; set xtics auto; set xtics 100,10; set xrange [80:3e5]; set yrange [0.4:500]; set ytics ("$1$" 1, "$10$" 10, "$100$" 100)
set xlabel "$N$"; set ylabel "times as fast as one reach" offset 1.6,0
set arrow from 80,1 to 3e5,1 nohead lt Guide back
set label ink(2, "$a_2/a_1=.1$") at 7.5e3,300 right; set label ink(4, "$.313$") at 1.2e4,21
set label ink(1, "$.5$") at 1.5e5,5.2; set label ink(3, "$1$") at 1.5e5,3
plot times("1") using "size":(fast(0)):(fast_err(0)) with yerrorlines lt 3, times("0.5") using "size":(fast(0)):(fast_err(0)) with yerrorlines lt 1, \
  times("0.313") using "size":(fast(0)):(fast_err(0)) with yerrorlines lt 4, times("0.1") using "size":(fast(0)):(fast_err(0)) with yerrorlines lt 2
unset label; unset arrow
set lmargin screen 0.115; set rmargin screen 0.475; set bmargin screen 0.105; set tmargin screen 0.47
set xtics 1e3,100; set xrange [1e3:1e9]; set yrange [3e-5:1]; set ytics 1e-4,10,1
set xlabel "pairs of these species" offset 0,0.5; set ylabel "error of the contact value" offset 2,0
set label ink(Coarse, "large, large:") at 1e9,0.42 right; set label ink(Coarse, "bin $.1$") at 1e9,0.18 right
set label ink(Coarse, "window of") at 1e9,0.018 right; set label ink(Coarse, "one size") at 1e9,0.0075 right
set label ink(Coarse, "ours") at 1e9,8e-4 right; set label ink(Fine, "small, small: ours") at 1.6e7,1e-4 right
plot contact("11", "bin", "0.1") using "pairs nearer than 1.25 contact distances":"rms" with lines lt Coarse dt 2, contact("11", "wide", "2") using "pairs nearer than 1.25 contact distances":"rms" with lines lt Coarse dt 3, \
  contact("11", "fit", "2") using "pairs nearer than 1.25 contact distances":"rms" with lines lt Coarse, contact("22", "fit", "2") using "pairs nearer than 1.25 contact distances":"rms" with lines lt Fine dt 4
unset label
set lmargin screen 0.64; set rmargin screen 0.985
set xtics 1e-5,100; set xrange [2e-6:0.3]; set yrange [3e-15:0.5]; set ytics 1e-15,1e3
set xlabel "seconds to prepare"; set ylabel "worst error of $g_{ij}$" offset 2.3,0
set label ink(Guide, "trapezoids") at 2e-5,1.5e-6; set label ink(Guide, "ours") at 1.2e-4,1e-11 right
plot curve("points-1") using "seconds":"error" with linespoints lt 3 dt 2, curve("points-0.5") using "seconds":"error" with linespoints lt 1 dt 2, \
  curve("points-0.1") using "seconds":"error" with linespoints lt 2 dt 2, \
  curve("1") using "seconds":"error" with linespoints lt 3, curve("0.5") using "seconds":"error" with linespoints lt 1, \
  curve("0.313") using "seconds":"error" with linespoints lt 4, curve("0.1") using "seconds":"error" with linespoints lt 2
unset multiplot
