# eta2 of a thousand balls: seconds of one core against the relative error.
# data: data/bench-seconds.tsv
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [1e-13:1]; set yrange [1e-3:1e2]; set xtics 100
set xlabel "relative error of $\\eta_2$"; set ylabel "seconds of one core" offset 1
way(m, label) = recorded("task=microstructure;method=".m.";case=".label)
plot way("multipoles", "discs") using "error":"seconds" with linespoints lt 1 title "discs, sums", \
  way("field", "discs") using "error":"seconds" with linespoints lt 3 title "field", \
  way("multipoles", "spheres") using "error":"seconds" with linespoints lt 2 title "spheres, sums", \
  way("field", "spheres") using "error":"seconds" with linespoints lt 4 title "field"
