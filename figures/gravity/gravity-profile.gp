# Packs by gravity from the middle to the rim, and the fraction of the inner half against the number of particles.
# data: gravity-size gravity-million gravity-discs
set terminal cairolatex pdf size 12.6cm,7cm font ",10" fontscale 0.9
set output out
shells(s, v) = data(s, "profile-shells@".v.".tsv")
set multiplot
set tmargin screen 0.96; set bmargin screen 0.18
set lmargin screen 0.10; set rmargin screen 0.53
unset key
set xrange [0:1]; set yrange [0:0.78]; set xtics 0.2; set ytics 0.2
set xlabel "$|\\mathbf x|/R_{\\rm out}$"; set label 9 "$\\phi$ of a shell" at screen 0.022,graph 0.5 center rotate
set label 2 ink(5, "$N=300$") at 0.2,0.36; set label 3 ink(3, "$3000$") at 0.2,0.29
set label 4 ink(2, "$30\\,000$") at 0.2,0.22; set label 5 ink(1, "$10^6$") at 0.2,0.15
plot shells("gravity-size", "300") using "x":"phi":"phi_err" with yerrorlines lt 5 lw 1 pt 11 ps 0.45, \
  shells("gravity-size", "3000") using "x":"phi":"phi_err" with yerrorlines lt 3 lw 1 pt 9 ps 0.45, \
  shells("gravity-size", "30000") using "x":"phi":"phi_err" with yerrorlines lt 2 lw 1 pt 5 ps 0.4, \
  shells("gravity-million", "1e+06") using "x":"phi":"phi_err" with yerrorlines lt 1 lw 1 pt 7 ps 0.4
unset label
set lmargin screen 0.69; set rmargin screen 0.985
set logscale x; set xrange [150:2e6]; set xtics ("$10^3$" 1e3, "$10^4$" 1e4, "$10^5$" 1e5, "$10^6$" 1e6)
set yrange [0.55:0.87]; set ytics 0.05
set xlabel "$N$"
set label 9 "$\\phi$ within $\\frac12R_{\\rm out}$" at screen 0.592,graph 0.5 center rotate
set label 1 ink(Spheres, "spheres") at 3e4,0.615; set label 2 ink(Discs, "discs") at 3e4,0.825
set label 3 ink(Source, "densest of spheres (\\B)") at 300,0.653
plot 0.6366 with lines lt Source dt 2 lw 0.8, \
  data("gravity-size", "sweep.tsv") using "species.[0].number":"phi_0.5":"phi_0.5_err" with yerrorlines lt Spheres lw 0.8 ps 0.55, \
  data("gravity-million", "sweep.tsv") using "species.[0].number":"phi_0.5":"phi_0.5_err" with yerrorlines lt Spheres lw 0.8 pt 4 ps 0.55, \
  data("gravity-discs", "sweep.tsv") using "species.[0].number":"phi_0.5":"phi_0.5_err" with yerrorlines lt Discs lw 0.8 ps 0.6
unset multiplot
