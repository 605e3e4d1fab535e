# The relative error of the contact value after a second of one core: by rule against the fraction; of Metropolis' against the window.
# data: efficiency efficiency-step data/bench-seconds.tsv
key(s, k) = real(system(sprintf("sed -n 's/#.*//; s/.*\\b%s *= \\([0-9.]*\\);.*/\\1/p' figures/shake/%s.scene", k, s)))
# The relative error of a mean over P realizations after so many operations between the samples, times the root of the seconds that
# these have taken; P is the scene's, an operation's seconds are the record's.
between(s) = (key(s, "samples") - 1)*key(s, "apart")
all(s) = key(s, "realizations")*between(s)/(key(s, "sweeps") + between(s))
root(s, l) = sqrt(all(s)*spent("task=shake;method=ours;size=2000;case=".l))
error(q, root) = column(q."_err")/column(q)*sqrt(column("shake_trials"))*root
# and the error of that error, as a part of it
doubt = 1/sqrt(2*(key("efficiency", "realizations") - 1))
rows(s, where) = columns(sprintf("where=%s %s", where, data(s, "sweep.tsv")))
rules = "chain newton dynamics"; full = "13 7 5"; open = "12 6 4"
of_rule(i) = i == 1 ? Chain : i == 2 ? Newton : Dynamics
array each_rule[3]
do for [i = 1:3] { each_rule[i] = root("efficiency", word(rules, i)) }
each_window = root("efficiency-step", "wide-window")
q = "shaken.contact"; exact = "shaken.contact_collision"
# the best window at each fraction
phis = "0.3 0.45 0.49 0.575"
array best[4]; array window[4]
do for [i = 1:4] {
  stats rows("efficiency-step", "fraction=".word(phis, i)) using "shake.radius":(error(q, each_window)) nooutput
  best[i] = STATS_min_y; window[i] = STATS_pos_min_y
}
set logscale y
set yrange [2e-4:1e-2]
set ytics ("$.0002$" 2e-4, "$.0005$" 5e-4, "$.001$" 1e-3, "$.002$" 2e-3, "$.005$" 5e-3, "$.01$" 1e-2); set mytics 1
unset key
set multiplot
set tmargin screen 0.97; set bmargin screen 0.17; set lmargin screen 0.125; set rmargin screen 0.6
set xrange [0.17:0.605]; set xtics (".30" 0.3, ".45" 0.45, ".49" 0.49, ".575" 0.575)
set xlabel "$\\phi$"; set label 9 "relative error after one second" at screen 0.02,graph 0.5 center rotate
set label 1 ink(Metropolis, "best $R_{\\rm sh}$") at 0.18,0.0075; set label 6 ink(Metropolis, "Metropolis $\\scriptstyle\\blacktriangle$") at 0.19,0.0042
set label 2 ink(Chain, "chain $\\scriptstyle\\blacklozenge$") at 0.18,0.00053; set label 3 ink(Newton, "Newton $\\bullet$") at 0.18,0.00029
set label 4 ink(Dynamics, "dynamics $\\scriptstyle\\blacksquare$") at 0.335,0.0030; set label 5 "open: from the virial" at 0.595,2.4e-4 right
at(i) = real(word(phis, i)) - 0.006
do for [i = 1:4] { set label 10 + i ink(Metropolis, sprintf("$%s$", sprintf("%g", window[i])[2:])) at real(word(phis, i)) + (i == 2 ? -0.008 : i == 3 ? 0.008 : 0),0.0075 center }
plot "+" using (at(int($0) + 1)):(best[int($0) + 1]):(doubt*best[int($0) + 1]) every ::0::3 with yerrorlines lt Metropolis lw 0.8 ps 0.55, \
  for [i = 1:3] rows("efficiency", "shake.rule=".word(rules, i)) using (column("fraction") + 0.003*(i - 2)):(error(q, each_rule[i])):(doubt*error(q, each_rule[i])) \
    with yerrorlines lt of_rule(i) lw 0.8 pt int(word(full, i)) ps 0.55, \
  for [i = 1:3] rows("efficiency", "shake.rule=".word(rules, i)) using (column("fraction") + 0.003*(i - 2)):(error(exact, each_rule[i])):(doubt*error(exact, each_rule[i])) \
    with yerrorlines lt of_rule(i) dt 2 lw 0.8 pt int(word(open, i)) ps 0.55
set lmargin screen 0.635; set rmargin screen 0.985
unset label
set label 1 ink(Metropolis, "$\\phi=.575$") at 0.1,0.0052; set label 2 ink(Metropolis, "$.49$") at 0.95,0.0038
set label 3 ink(Metropolis, "$.45$") at 0.95,0.0016; set label 4 ink(Metropolis, "$.30$") at 0.95,0.00095
set logscale x; set xrange [0.04:1.5]; set xtics (".05" 0.05, ".1" 0.1, ".2" 0.2, ".3" 0.3, ".5" 0.5, ".8" 0.8); set format y ""
set ytics ("" 2e-4, "" 5e-4, "" 1e-3, "" 2e-3, "" 5e-3, "" 1e-2); set mxtics 1
set xlabel "$R_{\\rm sh}$"
plot for [i = 1:4] rows("efficiency-step", "fraction=".word(phis, i)) using (column("shake.radius")*(1 + 0.02*(i - 2.5))):(error(q, each_window)):(doubt*error(q, each_window)) \
  with yerrorlines lt Metropolis lw 0.8 dt i pt int(word("8 10 9 11", i)) ps 0.5
unset multiplot
