# Where the literal protocol ends: the reduced rate, against that with which it began.
# data: growth-literal
lit = data("growth-literal", "sweep.tsv")
ending(phi) = sprintf("< awk -F'\\t' '/^#/ {next} !h {h=1; for (c=NF; c>0; c--) n[$c]=c; next} \
  $n[\"fraction\"]==%s && $n[\"reached\"]==1 {print $n[\"make.growth\"] FS $n[\"gamma\"] FS $n[\"gamma_err\"]}' %s", phi, lit)
set logscale xy
set xrange [6e-3:16]; set yrange [4e-4:60]
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xlabel "$a_0$"; set ylabel "$\\Gamma$ at the end" offset 1
set key at graph 0.03,0.97 left top Left reverse vertical
excess(p) = (4*p - 3*p**2)/(1 - p)**2
slow(p, x) = 2*sqrt(3)*x*exp(-excess(p)/3)
plot 2*sqrt(3)*x with lines lt 8 title "$2\\sqrt3\\,a_0$: at the start", \
  [*:0.3] slow(0.575, x) with lines lt 1 lw 0.7 dt 2 notitle, \
  [*:0.3] slow(0.6, x) with lines lt 2 lw 0.7 dt 2 notitle, \
  [*:0.3] slow(0.63, x) with lines lt 3 lw 0.7 dt 2 notitle, \
  ending("0.575") using 1:2:3 with yerrorlines lt 1 title "$.575$", \
  ending("0.6") using 1:2:3 with yerrorlines lt 2 title "$.60$", \
  ending("0.63") using 1:2:3 with yerrorlines lt 3 title "$.63$"
