# Growth without a thermostat: the temperature, and the reduced rate, against the fraction.
# data: growth-heating growth-theory
rows(a) = columns(sprintf("where=make.growth=%g %s", a, data("growth-heating", "sweep.tsv")))
set logscale y; set format y "$10^{%T}$"; unset mytics
set xlabel "$\\phi$"; set xrange [0:0.66]; set xtics 0.2
unset key
set multiplot layout 1,2 margins 0.125,0.985,0.18,0.97 spacing 0.14
set ylabel "$T/T_0$" offset 2.2,0
set yrange [0.6:3e10]; set ytics 1,100
set label ink(1, "$a_0=100$") at 0.03,2e6; set label ink(2, "10") at 0.1,4e3; set label ink(3, "1") at 0.1,40
set label ink(4, "$.1$") at 0.34,25 right; set label ink(5, "$.01$") at 0.44,5
# by the work of the fluid's pressure alone (Carnahan and Starling's)
still(x) = exp(2./3*x*(4 - 3*x)/(1 - x)**2)
plot for [i = 1:5] rows(10.**(3 - i)) using "fraction":"heating":"heating_err" with yerrorlines lt i, still(x) with lines lt Guide
unset label
set ylabel "$\\Gamma$" offset 2.2,0
set yrange [3e-4:6]; set ytics 1e-3,10
set label ink(1, "$a_0=100$,") at 0.15,2.4; set label ink(2, "10,") at 0.37,2.4; set label ink(3, "1") at 0.455,2.4
 set label ink(4, "$.1$") at 0.07,0.18; set label ink(5, "$.01$") at 0.07,0.02
plot for [i = 1:5] rows(10.**(3 - i)) using "fraction":"gamma":"gamma_err" with yerrorlines lt i, \
  for [a in "0.1 0.01"] 2*a*sqrt(3)/sqrt(still(x)) with lines lt Guide
unset multiplot
