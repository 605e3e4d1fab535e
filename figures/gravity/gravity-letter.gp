# G to the letter: the deepest overlap that is left, against the number of particles, for three steps and two numbers of passes.
# data: gravity-literal gravity-literal-discs
set terminal cairolatex pdf size 12.6cm,7cm font ",10" fontscale 0.9
set output out
rows(s, d, p) = columns("'where=make.step=".d.sprintf(";make.passes=%d' ", p).data(s, "sweep.tsv"))
step(i) = word("0.02 0.05 0.1", i)
set multiplot
set logscale xy; set xrange [200:60000]; set xtics ("300" 300, "1000" 1000, "3000" 3000, "$10^4$" 10000, "$3{\\cdot}10^4$" 30000)
set yrange [1e-11:4]; set format y "$10^{%T}$"; set ytics 100; set xlabel "$N$"
unset key
# a tenth of the way aside, so that bars do not cover each other
P(i) = column("species.[0].number") * 1.06**(i - 2)
over_floor(y) = y > 1.2e-11 ? y : 1.2e-11
set tmargin screen 0.96; set bmargin screen 0.18
do for [d = 0:1] {
  s = d ? "gravity-literal-discs" : "gravity-literal"
  set lmargin screen (d ? 0.595 : 0.125); set rmargin screen (d ? 0.985 : 0.51)
  unset label
  if (d) { set format y "" } else { set label 9 "deepest overlap, diameters" at screen 0.012,graph 0.5 center rotate }
  set label 1 (d ? "discs" : "spheres") at graph 0.04,0.62
  if (!d) {
    set label 2 ink(1, "$\\Delta r=.02\\,r_0$") at graph 0.04,0.54; set label 3 ink(2, "$.05\\,r_0$") at graph 0.04,0.47; set label 4 ink(3, "$.1\\,r_0$") at graph 0.04,0.40
    set label 5 "6 passes" at 7000,1e-3 center; set label 6 "100 passes" at 7000,1.5e-10 center
  }
  plot for [i = 1:3] rows(s, step(i), 6) using (P(i)):"overlap" with lines lt i lw 0.8, \
    for [i = 1:3] rows(s, step(i), 6) using (P(i)):"overlap":(over_floor(low("overlap"))):(high("overlap")) with yerrorbars lt i pt 2*i+5 ps 0.6, \
    for [i = 1:3] rows(s, step(i), 100) using (P(i)):(over_floor(column("overlap"))) with lines lt i lw 0.8 dt 2, \
    for [i = 1:3] rows(s, step(i), 100) using (P(i)):(over_floor(column("overlap"))):(over_floor(low("overlap"))):(high("overlap")) with yerrorbars lt i pt 2*i+4 ps 0.6
}
unset multiplot
