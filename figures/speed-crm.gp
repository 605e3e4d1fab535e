# Growth: microseconds a collision at constant radius against the number of particles.
# data: data/bench-seconds.tsv
ink(n, s) = "\\textcolor[HTML]{".word("0072B2 D55E00 009E73 CC79A7 B57B00 3A94C8 000000 777777", n)."}{".s."}"
rows(m, l) = sprintf("< awk -F'\\t' '$1==\"crm\" && $2==\"%s\" && $3==\"%s\"' data/bench-seconds.tsv", m, l)
set logscale xy
set format x "$10^{%T}$"; set mxtics 1
set xrange [250:250000]; set yrange [0.3:15]; set ytics (0.5, 1, 2, 5, 10)
set xlabel "number of particles, $N$"; set ylabel "$\\mu$s a collision" offset 1.5,0
set key inside top left vertical Left reverse
plot rows("plain_cells", "0.30") using 4:(1e6*$6/$5):(1e6*$7/$5) with yerrorlines lt 2 dt 2 title "plain, $\\phi=.30$", \
  rows("plain_cells", "0.54") using 4:(1e6*$6/$5):(1e6*$7/$5) with yerrorlines lt 1 dt 2 title "plain, $\\phi=.54$", \
  rows("ours", "0.30") using 4:(1e6*$6/$5):(1e6*$7/$5) with yerrorlines lt 2 title "ours, $\\phi=.30$", \
  rows("ours", "0.54") using 4:(1e6*$6/$5):(1e6*$7/$5) with yerrorlines lt 1 title "ours, $\\phi=.54$"
