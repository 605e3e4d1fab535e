# Fig. 4 of B: p(n_h) at c = .6 before and after shaking, windows on particles and on points; and what shaking changes.
# data: neighbour-histogram
set terminal cairolatex pdf size 12.6cm,11.6cm font ",10" fontscale 0.9
set output out
table(when, rule, centre, r) = data("neighbour-histogram", when.".histogram@".rule."@".centre."@".r.".tsv")
# below, a thousandfold the change of p, its error by the differences of the same packs
unset key
set multiplot
set lmargin screen 0.105; set rmargin screen 0.985; set tmargin screen 0.985; set bmargin screen 0.545
set xrange [3.5:16.5]; set xtics 2; set yrange [0:0.53]; set ytics 0.1
set xlabel "$n_h$, centres in the window of $r_h=2.5$" offset 0,0.7; set label 9 "$p(n_h)$" at screen 0.022,graph 0.5 center rotate
set object 1 rectangle from 6,0 to 14,0.3 fs empty border lc rgb "#777777" dt 3 behind
set label 1 ink(Guide, "axes of") at 14.1,0.29; set label 8 ink(Guide, "B's Fig.~4") at 14.1,0.25
set label 2 "on points $\\triangle$" at 7.9,0.235 right
set label 3 "on particles, not counted $\\scriptstyle\\square$" at 10.3,0.37 right
set label 5 "$\\circ$ on particles, counted" at 12.4,0.37
set label 6 ink(Grown, "lines: as grown") at graph 0.98,0.96 right; set label 7 ink(Retry, "symbols: after 60 shakes, retry") at graph 0.98,0.88 right
plot for [w = 1:3] table("made", "retry", word("counted excluded random", w), "2.5") using "n":"p":"p_err" with yerrorlines lt Grown pt 0 lw 1.4, \
  for [w = 1:3] table("shaken", "retry", word("counted excluded random", w), "2.5") using "n":"p":"p_err" with yerrorbars lt Retry lw 1 pt (w == 1 ? 6 : w == 2 ? 4 : 8) ps 0.7
unset object; unset label
set tmargin screen 0.355; set bmargin screen 0.105
set xtics 2; set ytics 2
do for [j = 1:3] {
  r = word("2.2 2.5 3", j)
  set lmargin screen 0.105 + 0.301*(j - 1); set rmargin screen 0.383 + 0.301*(j - 1)
  set xrange [real(word("2.5 4.5 9.5", j)):real(word("13.5 15.5 22.5", j))]; set xtics 2; set yrange [-6:6]; set ytics 2
  set xlabel "$n_h$" offset 0,0.7
  unset label
  if (j == 1) { set format y "$%g$"; set label "$10^3\\times$ change of $p$" at screen 0.02,graph 0.5 center rotate by 90 } else { set format y "" }
  set label sprintf("$r_h=%s$", r) at graph 0.05,0.9
  if (j == 2) { set label ink(Retry, "$\\scriptstyle\\square$ on particles, retry")."\\quad ".ink(Metropolis, "$\\scriptstyle\\blacktriangle$ on particles, Metropolis")."\\quad ".ink(Retry, "$\\triangle$ on points, retry") at screen 0.545,0.39 center }
  plot 0 with lines lt Guide, table("shaken", "metropolis", "excluded", r) using (column("n") + 0.15):(1000*column("change")):(1000*column("change_err")) with yerrorbars lt Metropolis ps 0.5, \
    table("shaken", "retry", "excluded", r) using "n":(1000*column("change")):(1000*column("change_err")) with yerrorlines lt Retry pt 4 ps 0.55, table("shaken", "retry", "random", r) using (column("n") - 0.15):(1000*column("change")):(1000*column("change_err")) with yerrorlines lt Retry dt 2 lw 1 pt 8 ps 0.6
}
unset multiplot
