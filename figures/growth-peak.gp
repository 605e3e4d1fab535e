# The first bin of g(r) against the rate of growth, two protocols, and against what the growth cost.
# data: growth-iso growth-literal
iso = data("growth-iso", "sweep.tsv"); lit = data("growth-literal", "sweep.tsv")
set terminal cairolatex pdf size 13.8cm,8.6cm font ",10" fontscale 0.9 linewidth 1 dashlength 1.2
set output out
phis = "0.575 0.6 0.63"
peak(f, phi, x) = sprintf("< awk -F'\\t' '/^#/ {next} !h {h=1; for (c=NF; c>0; c--) n[$c]=c; next} \
  $n[\"fraction\"]==%s && $n[\"reached\"]==1 {print %s FS $n[\"contact_first_bin\"] FS $n[\"contact_first_bin_err\"] FS $n[\"solid_fraction\"]}' %s", phi, x, f)
rate = "$n[\"make.growth\"]"; cost = "2*$n[\"collisions\"]/$n[\"number\"]"
set multiplot layout 1,3
set logscale xy; set yrange [8:90]
set ytics (8, 10, 15, 20, 30, 40, 60, 80); set format x "$10^{%T}$"
unset key
set lmargin screen 0.085; set rmargin screen 0.365; set tmargin screen 0.90; set bmargin screen 0.15
set ylabel "$g$ in $2\\le R<2.01$" offset 1.5,0
set xlabel "$\\Gamma$"; set xrange [5e-4:2]; set title "isothermal" offset 0,-0.7
set label 1 "$.63$" at 0.03,62 center; set label 2 "$.60$" at 0.11,24 left; set label 3 "$.575$" at 0.13,14.2 left
plot for [k=1:3] peak(iso, word(phis, k), rate) using 1:2:3 with yerrorlines lt k, \
  for [k=1:3] peak(iso, word(phis, k), rate) using 1:($4 > 0.05 ? $2 : NaN) with points pt 6 ps 1.3 lc rgb "#000000"
unset ylabel; set format y ""; unset label 1; unset label 2; unset label 3
set lmargin screen 0.385; set rmargin screen 0.665
set xlabel "$a_0$"; set xrange [5e-3:20]; set title "literal"
plot for [k=1:3] peak(lit, word(phis, k), rate) using 1:2:3 with yerrorlines lt k
set lmargin screen 0.685; set rmargin screen 0.985
set xlabel "collisions a particle"; set xrange [30:2e4]; set title "either"
set label 1 "filled: isothermal" at graph 0.97,0.96 right; set label 2 "open: literal" at graph 0.97,0.90 right
plot for [k=1:3] peak(iso, word(phis, k), cost) using 1:2:3 with yerrorlines lt k, \
  for [k=1:3] peak(lit, word(phis, k), cost) using 1:2:3 with yerrorlines lt k dt 2 pt (k == 1 ? 6 : k == 2 ? 4 : 8)
unset multiplot
