# Bounds on a propellant's stiffness as phi grows, and what shaking changes of them.
# data: stiffness
set terminal cairolatex pdf size 12.6cm,6.6cm font ",10" fontscale 0.9
set output out
table = data("stiffness", "sweep.tsv")
unset key
set multiplot
set lmargin screen 0.11; set rmargin screen 0.48; set tmargin screen 0.97; set bmargin screen 0.17
set xrange [0.07:0.67]; set xtics 0.1; set logscale y; set yrange [2:20000]; set ytics 10; set format y "$10^{%T}$"
set xlabel "$\\phi$" offset 0,0.4; set label 9 "Young's modulus / $G$ of the matrix" at screen 0.015,graph 0.5 center rotate
set label 1 "by $\\phi$ alone" at 0.12,4500
set label 2 "by $\\zeta_2$, $\\eta_2$:" at 0.65,220 right; set label 3 ink(Grown, "as grown (line)") at 0.65,105 right; set label 4 ink(Metropolis, "shaken $\\scriptstyle\\blacktriangle$") at 0.65,50 right
plot table using "fraction":"made.young_two_upper" with lines lt Guide, table using "fraction":"made.young_two_lower" with lines lt Guide, \
  table using "fraction":"made.young_upper" with lines lt Grown, table using "fraction":"made.young_lower" with lines lt Grown, \
  table using "fraction":"shaken.young_upper" with points lt Metropolis ps 0.5, table using "fraction":"shaken.young_lower" with points lt Metropolis ps 0.5
unset label; unset logscale y
set lmargin screen 0.62; set rmargin screen 0.985
set yrange [-5:9]; set ytics 2; set mytics 2; set format y "$%g$"
set xlabel "$\\phi$" offset 0,0.4; set label 9 "change by shaking, per cent" at screen 0.54,graph 0.5 center rotate
set key at graph 0.97,0.97 right vertical samplen 1.5
percent(name) = 100*column(name)
plot table using (column("fraction") - 0.006):(percent("change.zeta2")):(percent("change.zeta2_err")) with yerrorbars lt 2 pt 5 ps 0.4 title "$\\zeta_2$", \
  table using "fraction":(percent("change.young_upper")):(percent("change.young_upper_err")) with yerrorbars lt 1 ps 0.45 title "upper bound", \
  table using (column("fraction") + 0.006):(percent("change.young_lower")):(percent("change.young_lower_err")) with yerrorbars lt 3 pt 9 ps 0.4 title "lower bound"
unset multiplot
