# Growth: microseconds a collision at constant radius against the number of particles.
# data: data/bench-seconds.tsv
rows(m, l) = recorded(sprintf("task=crm;method=%s;case=%s", m, l))
# The power of N that fits each best, by least squares of the logarithms.
stats rows("plain_cells", "0.30") using (log(column("size"))):(log(each(1))) name "A" nooutput
stats rows("plain_cells", "0.54") using (log(column("size"))):(log(each(1))) name "B" nooutput
stats rows("ours", "0.30") using (log(column("size"))):(log(each(1))) name "C" nooutput
stats rows("ours", "0.54") using (log(column("size"))):(log(each(1))) name "D" nooutput
says(who, phi, slope) = sprintf("%s, $\\phi=%s$: $N^{%s}$", who, phi, sprintf("%.2f", slope)[2:])
set logscale xy
set format x "$10^{%T}$"; set mxtics 1
set xrange [250:250000]; set yrange [0.3:30]; set ytics (0.5, 1, 2, 5, 10, 20)
set xlabel "number of particles, $N$"; set ylabel "$\\mu$s a collision" offset 1.5,0
set key inside top left vertical Left reverse
plot rows("plain_cells", "0.30") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt 2 dt 2 title says("plain", ".30", A_slope), \
  rows("plain_cells", "0.54") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt 1 dt 2 title says("plain", ".54", B_slope), \
  rows("ours", "0.30") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt 2 title says("ours", ".30", C_slope), \
  rows("ours", "0.54") using "size":(each(1e6)):(each_err(1e6)) with yerrorlines lt 1 title says("ours", ".54", D_slope)
