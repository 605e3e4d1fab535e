# The first bin of g at .35 against the number of shakes from four starts, by two rules with two windows; below, the order Q6 of the crystal's.
# data: forget-rsa forget-crystal forget-slow forget-fast
set terminal cairolatex pdf size 12.6cm,13cm font ",10"
set output out
file(start, rule, radius) = data("forget-".start, sprintf("shaking@%s@%s.tsv", rule, radius))
fluid = equation("schultz", 0.35, "g(2+)")
at(m) = m > 0 ? m : 0.45
starts = "fast rsa slow crystal"; style = "1 10 1 11"; form = "5 13 6 9"
set logscale x
set xrange [0.4:6000]; set mxtics 1
unset key
set multiplot
do for [k = 1:2] {
  radius = word("0.02 0.2", k)
  set lmargin screen (k == 1 ? 0.11 : 0.56); set rmargin screen (k == 1 ? 0.535 : 0.985)
  do for [j = 1:2] {
    rule = word("metropolis retry", j); name = word("Metropolis retry", j)
    set tmargin screen (j == 1 ? 0.99 : 0.67); set bmargin screen (j == 1 ? 0.695 : 0.375)
    unset label; unset arrow
    set yrange [0:7.6]; set format x ""; unset xlabel; set ytics 2
    set xtics (0.45, 1, 10, 100, 1000)
    if (k == 1) { set label 9 "$g$, first bin" at screen 0.022,graph 0.5 center rotate; set format y "%g" } else { set format y "" }
    set label 1 sprintf("%s, $R_{\\rm sh}=%s$", ink(int(word("3 2", j)), name), radius[2:]) at graph 0.97,0.94 right
    set arrow 1 from 0.4,fluid to 6000,fluid nohead lt Guide
    if (k == 1 && j == 1) {
      set label 2 ink(Grown, "fast growth") at 30,5.1 right; set label 3 ink(Added, "random addition") at 0.5,4.05
      set label 4 ink(Grown, "slow growth") at 0.5,2.2; set label 5 ink(Jammed, "crystal") at 0.5,0.5
      }
    if (k == 2 && j == 2) { set label 6 ink(Guide, "fluid, $g(2^+)$") at 5500,fluid + 0.55 right }
    plot for [i = 1:4] file(word(starts, i), rule, radius) using (at(column("M"))*(1 + 0.04*(i - 2.5))):"contact_first_bin":"contact_first_bin_err" with yerrorlines lt int(word(style, i)) lw 0.8 pt int(word(form, i)) ps (i == 2 ? 0.55 : 0.5)
  }
  unset label; unset arrow
  set tmargin screen 0.35; set bmargin screen 0.092
  set yrange [0:0.65]; set ytics 0.2; set format x "%g"
  set xtics ("0" 0.45, "1" 1, "10" 10, "100" 100, "1000" 1000)
  set xlabel "shakes" offset 0,0.5
  if (k == 1) { set label 9 "$Q_6$ from the crystal" at screen 0.022,graph 0.5 center rotate; set format y "%.1f" } else { set format y "" }
  if (k == 2) { set label 1 ink(Metropolis, "$\\scriptstyle\\blacktriangle$ Metropolis") at graph 0.97,0.92 right; set label 3 ink(Retry, "$\\scriptstyle\\square$ retry") at graph 0.97,0.77 right }
  if (k == 1) { set label 2 ink(Guide, "from random addition") at 0.5,0.075 }
  plot file("crystal", "metropolis", radius) using (at(column("M"))):"Q6":"Q6_err" with yerrorlines lt Metropolis lw 0.8 ps 0.55, \
    file("crystal", "retry", radius) using (at(column("M"))*1.05):"Q6":"Q6_err" with yerrorlines lt Retry dt 2 pt 4 lw 0.8 ps 0.65, \
    file("rsa", "metropolis", radius) using (at(column("M"))*0.95):"Q6" with lines lt Guide
}
unset multiplot
