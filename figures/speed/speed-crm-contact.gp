# The contact value at .49 by the collisions spent: left, from a run at rest by four methods; right, by growth.
# data: build/data/speed/summary.tsv
rows(m) = columns(sprintf("where=method=%s build/data/speed/crm-contact.tsv", m))
grown(m) = columns(sprintf("where=method=%s build/data/speed/crm-rate.tsv", m))
# off the scale below its error
bias(x) = column("bias") > column("its error") ? column("bias") : NaN
set logscale xy
set format x "$10^{%T}$"; set mxtics 1
unset key
set yrange [0.1:300]; set ytics ("$.1$" 0.1, "$1$" 1, "$10$" 10, "$100$" 100)
set xlabel "collisions a particle"
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.97 spacing 0.04
set xrange [5:2000]
set ylabel "error of the contact value, per cent" offset 1.5,0
set label 5 "rms of one run" at graph 0.98,0.95 right; set label 1 ink(2, "bin $.1a$") at 150,27; set label 2 ink(5, "bin $.01a$") at 120,4.3
set label 3 ink(3, "parabola") at 1900,0.6 right; set label 4 ink(1, "rate") at 30,0.75 right
plot rows("wide") using "collisions a particle":"rms" with linespoints lt 2, rows("thin") using "collisions a particle":"rms" with linespoints lt 5, \
  rows("fit") using "collisions a particle":"rms" with linespoints lt 3, rows("rate") using "collisions a particle":"rms" with linespoints lt 1
unset label
unset ylabel; set format y ""; set xrange [12:3000]; set ytics ("" 0.1, "" 1, "" 10, "" 100)
set label 1 ink(Isothermal, "growth") at 250,6.5; set label 2 ink(Dynamics, "growth, then rest") at 75,1.6 center; set label 3 "excess of packs that grew" at graph 0.98,0.95 right
plot grown("grown") using "collisions a particle":(bias(0)):"its error" with yerrorlines lt Isothermal, grown("rest") using "collisions a particle":(bias(0)):"its error" with yerrorlines lt Dynamics
unset multiplot
