# The drop of the first peak against the window, the number of tries, and the shakes on the way.
# data: shake-window shake-tries shake-way
set terminal cairolatex pdf size 12.6cm,11.6cm font ",10" fontscale 0.9
set output out
# rows of a sweep on which the condition holds; columns by name
rows(s, where) = columns(sprintf("'where=%s' %s", where, data(s, "sweep.tsv")))
per(name) = 100*column(name)
unset key
set multiplot
set logscale x
set tmargin screen 0.955; set bmargin screen 0.565
set xrange [0.004:0.28]; set xtics (".005" 0.005, ".02" 0.02, ".1" 0.1, "" 0.01, "" 0.04, "" 0.2); unset mxtics
set yrange [-60:10]; set ytics 20
set xlabel "window $R_{\\rm sh}$" offset 0,0.7
do for [j = 1:3] {
  phi = word("0.575 0.6 0.63", j); b = real(word("-43 -21 -4", j))
  set lmargin screen 0.118 + 0.297*(j - 1); set rmargin screen 0.391 + 0.297*(j - 1)
  unset label; unset arrow
  if (j == 1) { set label "(a) change of the peak, \\%" at screen 0.018,graph 0.5 center rotate by 90; set format y "$%g$" } else { set format y "" }
  set label sprintf("$\\phi=%s$", word(".575 .60 .63", j)) at graph 0.5,1.06 center
  set label "B" at 0.02,b - 5.5 center
  if (j == 3) { set label ink(Metropolis, "Metropolis, .01") at graph 0.99,0.44 right; set label ink(Retry, "retry, by bins of") at graph 0.99,0.35 right
    set label ink(Retry, "$\\scriptstyle\\blacktriangle$ .001, $\\scriptstyle\\blacksquare$ .01, $\\bullet$ .05") at graph 0.99,0.26 right }
  plot 0 with lines lt Guide, \
    rows("shake-window", "shake.rule=metropolis;fraction=".phi) using "shake.radius":(per("change.exact_0.01")):(per("change.exact_0.01_err")) with yerrorlines lt Metropolis dt 2 pt 8 ps 0.5, \
    for [w = 1:3] rows("shake-window", "shake.rule=retry;fraction=".phi) using "shake.radius":(per("change.exact_".word("0.001 0.01 0.05", w))):(per("change.exact_".word("0.001 0.01 0.05", w)."_err")) \
      with yerrorlines lt Retry lw 1 dt 0 + (w == 2 ? 1 : w + 1) pt (w == 1 ? 9 : 2*w + 1) ps 0.55, \
    "+" using (0.02):(b) every ::0::0 with points lt Source pt 12 ps 1.1
}
unset label
set tmargin screen 0.41; set bmargin screen 0.10
set lmargin screen 0.118; set rmargin screen 0.52
set xrange [0.8:200]; set xtics ("1" 1, "2" 2, "5" 5, "15" 15, "150" 150); set yrange [-48:5]; set ytics 10; set format y "$%g$"
set xlabel "$N_{\\rm sh}$, trials at most" offset 0,0.7
set label "(b) change of the peak, \\%" at screen 0.018,graph 0.5 center rotate by 90
set label "B" at 128,-43 right; set label ink(Retry, "retry, $R_{\\rm sh}=$") at graph 0.03,0.22; set label ink(Retry, "$\\scriptstyle\\blacktriangle$ .01, $\\scriptstyle\\blacksquare$ .02, $\\bullet$ .05") at graph 0.03,0.12
plot 0 with lines lt Guide, "+" using (150):(-43) every ::0::0 with points lt Source pt 12 ps 1.1, for [w = 1:3] rows("shake-tries", "fraction=0.575;shake.radius=".word("0.01 0.02 0.05", w)) \
  using "shake.tries":(per("change.contact_first_bin")):(per("change.contact_first_bin_err")) with yerrorlines lt Retry lw 1 dt 0 + (w == 2 ? 1 : w + 1) pt (w == 1 ? 9 : 2*w + 1) ps 0.55
unset label
set lmargin screen 0.64; set rmargin screen 0.985
set xrange [0.15:40]; set xtics (".2" 0.2, "1" 1, "5" 5, "30" 30); set yrange [8.5:16]; set ytics 2; set format y "%g"
set xlabel "collisions between shakes" offset 0,0.7
set label "(c) first peak" at screen 0.565,graph 0.5 center rotate by 90
set label ink(Metropolis, "Metropolis") at graph 0.95,0.98 right; set label ink(Retry, "retry") at graph 0.95,0.63 right
set label "full: at the end of growth" at graph 1,0.26 right; set label "open: 10 shakes later" at graph 1,0.13 right
way(w) = rows("shake-way", "shake.rule=".word("metropolis retry", w))
plot for [w = 1:2] way(w) using (1.04*column("shake.every")):"shaken.contact_first_bin":"shaken.contact_first_bin_err" with yerrorlines lt (w == 1 ? Metropolis : Retry) dt 2 pt (w == 1 ? 8 : 4) ps 0.55, \
  for [w = 1:2] way(w) using (column("shake.every")/1.04):"made.contact_first_bin":"made.contact_first_bin_err" with yerrorlines lt (w == 1 ? Metropolis : Retry) ps 0.5
unset multiplot
