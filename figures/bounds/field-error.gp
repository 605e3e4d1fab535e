# zeta and eta by the field against those by multipoles, of the same packs of discs.
# data: field-error
off(what) = columns("of='".what."@*' ".data("field-error", "summary.tsv"))
set logscale xy; set xrange [4:50]; set yrange [5e-5:0.7]
set xtics (5, 10, 20, 40); set format y "$10^{%T}$"
set xlabel "pixels to a radius"; set ylabel "relative error" offset 1
set key at graph 0.98,0.96 right vertical
plot off("told") using "at":"value" with linespoints lt Guide pt 6 ps 0.6 title "reported", \
  off("eta_off") using "at":"value" with linespoints lt 2 pt 5 ps 0.6 title "$\\eta_2$", \
  off("zeta_off") using "at":"value" with linespoints lt 1 pt 7 ps 0.6 title "$\\zeta_2$"
