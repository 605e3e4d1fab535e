# Packs by gravity: microseconds a particle, and the deepest overlap left, against the number of particles.
# data: build/data/speed/summary.tsv build/data/seconds/summary.tsv data/bench-seconds.tsv
rows(m, l) = recorded(sprintf("task=gravity;method=%s;case=%s", m, l))
left(m, d) = columns(sprintf("'where=mode=%s;dimension=%d' build/data/speed/gravity.tsv", m, d))
# The power of P over the last decade, of the seconds in all.
power(m, l) = sprintf("%.2f", known("seconds", sprintf("gravity_%s_%s_power", m, l)))
says(n, what, m, l) = ink(n, sprintf("%s $N^{%s}$", what, power(m, l)))
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"; set mxtics 1; set mytics 1
unset key
set multiplot
set xlabel "number of particles, $N$"
set bmargin screen 0.17; set tmargin screen 0.97
set lmargin screen 0.10; set rmargin screen 0.52
set xrange [700:1.5e5]; set xtics 1e3,10; set yrange [3:900]
set ytics ("$3$" 3, "$10$" 10, "$30$" 30, "$100$" 100, "$300$" 300)
set ylabel "$\\mu$s a particle" offset 1.8,0
set label says(Law, "all pairs", "plain_all", "literal-3") at 9e2,600
set label says(Discs, "adaptive, 2-D", "ours", "adaptive-2") at 1.5e5,110 right
set label says(Spheres, "3-D", "ours", "adaptive-3") at 1.5e5,62 right
set label says(Spheres, "literal, 3-D", "ours", "literal-3") at 1.5e5,17 right
set label says(Discs, "literal, 2-D", "ours", "literal-2") at 1.5e5,3.9 right
plot rows("plain_all", "literal-3") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt Law, \
  rows("ours", "adaptive-2") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt Discs, \
  rows("ours", "adaptive-3") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt Spheres, \
  rows("ours", "literal-2") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt Discs dt 2 pt 6, \
  rows("ours", "literal-3") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt Spheres dt 2 pt 4
unset label
set lmargin screen 0.69; set rmargin screen 0.985
set yrange [1e-10:8]; set ytics 1e-9,1e3; set ylabel "deepest overlap left, diameters" offset 1.6,0
set label ink(Discs, "literal, 2-D") at 1.5e3,2.6; set label ink(Spheres, "3-D") at 4e3,1e-2
set label "adaptive, 2-D and 3-D" at 9e2,6e-9
plot left("literal", 2) using "P":"overlap":"overlap_err" with errorbars lt Discs pt 6, "" using "P":"overlap" with linespoints lt Discs dt 2 pt 6, \
  left("literal", 3) using "P":"overlap":"overlap_err" with errorbars lt Spheres pt 4, "" using "P":"overlap" with linespoints lt Spheres dt 2 pt 4, \
  left("adaptive", 2) using "P":"overlap" with linespoints lt Discs, left("adaptive", 3) using "P":"overlap" with linespoints lt Spheres
unset multiplot
