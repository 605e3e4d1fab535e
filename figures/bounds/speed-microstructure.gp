# eta2 of a thousand balls: seconds of one core against the relative error.
# data: data/bench-seconds.tsv
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [1e-13:1]; set yrange [1e-3:1e3]; set xtics 100
set key at graph 0.70,0.99 right vertical
set xlabel "relative error of $\\eta_2$"; set ylabel "seconds of one core" offset 1
way(m, label) = recorded("task=microstructure;method=".m.";case=".label)
plot way("multipoles", "discs") using "error":"seconds" with linespoints lt Discs title "discs, sums", \
  way("field", "discs") using "error":"seconds" with linespoints lt Discs dt 2 pt 6 title "discs, field", \
  way("multipoles", "spheres") using "error":"seconds" with linespoints lt Spheres title "spheres, sums", \
  way("field", "spheres") using "error":"seconds" with linespoints lt Spheres dt 2 pt 4 title "spheres, field"
