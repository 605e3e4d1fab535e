# At c = .575: contact value and solid fraction against the sweeps of Metropolis' rule, chains and dynamics.
# data: shake-drift
set terminal cairolatex pdf size 12.6cm,6.6cm font ",10" fontscale 0.9
set output out
curve(r) = data("shake-drift", "shaking@".r.".tsv")
rule(i) = word("metropolis chain newton dynamics", i)
of_rule(i) = i == 1 ? Metropolis : i == 2 ? Chain : i == 3 ? Newton : Dynamics
# the state before the first sweep stands at one third
at(m) = m > 0 ? m : 0.33
set logscale x; set xrange [0.25:4500]; set xtics ("0" 0.33, 1, 10, 100, 1000); unset mxtics
set xlabel "sweeps"
unset key
set multiplot layout 1,2 margins 0.115,0.985,0.19,0.97 spacing 0.16
set label "$g(2^+)$" at screen 0.015,graph 0.5 center rotate
set label ink(Metropolis, "$\\scriptstyle\\blacktriangle$ Metropolis") at graph 0.05,0.33
set label ink(Chain, "$\\scriptstyle\\blacklozenge$ straight chains") at graph 0.05,0.25
set label ink(Newton, "$\\bullet$ Newtonian chains") at graph 0.05,0.17
set label ink(Dynamics, "$\\scriptstyle\\blacksquare$ dynamics") at graph 0.05,0.09
plot for [i = 1:4] curve(rule(i)) using (at(column("M"))):"contact":"contact_err" with yerrorlines lt of_rule(i) pt (i == 1 ? 9 : i == 2 ? 13 : i == 3 ? 7 : 5)
unset label
set label "solid fraction" at screen 0.52,graph 0.5 center rotate
set ytics 0.05
plot for [i = 1:4] curve(rule(i)) using (at(column("M"))):"solid_fraction":"solid_fraction_err" with yerrorlines lt of_rule(i) pt (i == 1 ? 9 : i == 2 ? 13 : i == 3 ? 7 : 5)
unset multiplot
