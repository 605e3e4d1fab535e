# g near contact from samples of shaken packs in equilibrium, by each rule: above; below, over that of dynamics.
# data: shake-truth
set terminal cairolatex pdf size 12.6cm,10.6cm font ",10"
set output out
curve(r, c) = data("shake-truth", sprintf("shaken.rdf@%s@%g.tsv", r, c))
fluid(c) = equation("schultz", c, "g(2+)")
window = real(system("sed -n 's/^shake .*radius = \\([0-9.]*\\);.*/\\1/p' figures/shake/shake-truth.scene"))
# g over that of dynamics, three bins together
ratio(r, c) = columns("bin=3 ".curve(r, c)." ".curve("dynamics", c))
unset key
set xrange [2:2.5]; set xtics 0.1
set multiplot
set tics front
do for [j = 1:2] {
  c = real(word("0.3 0.49", j)); top = real(word("6.2 11.4", j))
  set lmargin screen (j == 1 ? 0.125 : 0.59); set rmargin screen (j == 1 ? 0.505 : 0.98)
  set tmargin screen 0.98; set bmargin screen 0.425
  unset label; unset arrow; unset object
  set object 1 rectangle from 2,graph 0 to 2 + window,graph 1 fs solid noborder fc rgb "#eeeeee" behind
  set yrange [0:top]; set format x ""; unset xlabel; set format y "%g"; set ytics auto
  if (j == 1) { set ytics 2; set label 9 "$g(R)$" at screen 0.02,graph 0.5 center rotate } else { set ytics 2 }
  set label 1 sprintf("$\\phi=%s$", word(".30 .49", j)) at graph 0.97,0.94 right front
  set label 2 "$R_{\\rm sh}$" at 2 + 0.96*window,graph 0.94 right front
  if (j == 1) {
    set label 3 ink(Collision, "collision") at 2.014,4.9 front
    set label 4 ink(Guide, "fluid, $g(2^+)$") at 2.14,3.6 front
    set arrow 1 from 2.135,3.5 to 2.012,fluid(c) + 0.12 nohead lt Guide dt 1
  } else {
    set label 3 ink(Retry, "retry") at 2.012,3.25 front
    set label 4 ink(Longest, "longest") at 2.265,5.5 front
    set label 5 ink(Metropolis, "Metropolis $\\scriptstyle\\blacktriangle$, ").ink(Chain, "chain $\\scriptstyle\\blacklozenge$,") at 2.475,8.3 right front
    set label 6 ink(Newton, "Newton $\\bullet$, ").ink(Dynamics, "dynamics (line)") at 2.475,7.4 right front
  }
  plot curve("collision", c) using "R":"g" with lines lt Collision dt 3, curve("collision-longest", c) using "R":"g" with lines lt Longest dt 2, \
    curve("retry", c) using "R":"g" with lines lt Retry, curve("newton", c) using "R":"g" with points lt Newton pt 7 ps 0.35, \
    curve("chain", c) using "R":"g" with points lt Chain ps 0.35, curve("metropolis", c) using "R":"g" with points lt Metropolis ps 0.35, \
    curve("dynamics", c) using "R":"g" with lines lt Dynamics, \
    "+" using (2.0):(fluid(c)) every ::0::0 with points pt 2 ps 1.1 lw 2 lc rgb "#000000"
  set tmargin screen 0.39; set bmargin screen 0.11
  unset label; unset arrow
  set yrange [0.93:1.075]; set ytics 0.05; set format x "%g"
  set xlabel "$R=r/a$" offset 0,0.5
  if (j == 1) { set label 9 "$g$ over dynamics" at screen 0.015,graph 0.5 center rotate; set format y "%.2f" } else { set format y "" }
  plot 1 with lines lt Dynamics, ratio("retry", c) using "R":(over("g")) with lines lt Retry, ratio("collision", c) using "R":(over("g")) with lines lt Collision dt 3, \
    ratio("metropolis", c) using (column("R") - 0.004):(over("g")):(over_err("g")) with yerrorbars lt Metropolis ps 0.5, \
    ratio("chain", c) using "R":(over("g")):(over_err("g")) with yerrorbars lt Chain ps 0.5, ratio("newton", c) using (column("R") + 0.004):(over("g")):(over_err("g")) with yerrorbars lt Newton pt 7 ps 0.45
}
unset multiplot
