# Two sizes by gravity: fraction against the ratio of the radii in the two ways of G, and against the coarse share at ten to one.
# data: gravity-two gravity-two-discs gravity-product gravity-size gravity-discs
set terminal cairolatex pdf size 12.6cm,6.8cm font ",10" fontscale 0.9
set output out
rows(s, how) = columns("'where=species.[1].grow=".how."' ".data(s, "sweep.tsv"))
f = known("gravity-discs", "phi_0.6@30000")
set multiplot
unset key
set tmargin screen 0.96; set bmargin screen 0.19
set lmargin screen 0.115; set rmargin screen 0.48
set xrange [1:6.5]; set xtics 1; set yrange [0.55:0.92]; set ytics 0.05
set xlabel "radius of the coarse by that of the fine"; set label 9 "$\\phi$ of the core" at screen 0.02,graph 0.5 center rotate
set label 1 "discs" at 1.3,0.80; set label 2 "spheres" at 1.3,0.63
set label 3 ink(1, "$\\bullet$ added") at 4.2,0.885; set label 4 ink(2, "$\\scriptstyle\\blacktriangle$ marked") at 5.1,0.815
plot for [i = 1:2] rows("gravity-two", word("add mark", i)) using "species.[1].radius":"fraction":"fraction_err" with yerrorlines lt i lw 0.8 pt 2*i+5 ps 0.55, \
  for [i = 1:2] rows("gravity-two-discs", word("add mark", i)) using "species.[1].radius":"fraction":"fraction_err" with yerrorlines lt i lw 0.8 pt 2*i+5 ps 0.55
unset label
set lmargin screen 0.65; set rmargin screen 0.985
set xrange [0:1]; set xtics 0.25; set yrange [0.82:1]; set ytics 0.05
set xlabel "coarse share of the volume"; set label 9 "$\\phi$ of the core" at screen 0.565,graph 0.5 center rotate
set label 1 ink(Law, "$1-(1-\\phi)^2$") at 0.62,0.985 right
set label 2 ink(1, "10 to 1") at 0.55,0.858
plot (x < 1/(2 - f) ? f/(1 - x*(1 - f)) : f/x) with lines lt Law dt 2 lw 0.8, \
  data("gravity-product", "sweep.tsv") using "core.coarse":"fraction":"core.coarse_err":"fraction_err" with xyerrorbars lt 1 pt 7 ps 0.55
unset multiplot
