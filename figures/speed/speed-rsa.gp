# RSA: what is missing from saturation against the work a particle, and seconds a particle.
# data: build/data/speed/summary.tsv data/bench-seconds.tsv
ops = "attempts, or trials and tests, a particle"
work(m, d) = columns(sprintf("'where=method=%s;dimension=%d;missing fraction>0' build/data/speed/rsa.tsv", m, d))
rows(m, w) = recorded(sprintf("task=rsa;method=%s;case=%s*;error>0", m, w))
full(d) = real(system(sprintf("awk -f figures/tools/columns.awk 'get=%s' 'where=method=ours;dimension=%d;missing fraction=0' build/data/speed/rsa.tsv", ops, d)))
saturated(w) = spent(sprintf("task=rsa;case=%s-saturated;size=10000", w))
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set mxtics 1
set yrange [8e-4:0.8]; set ytics 1e-3,10
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.97 spacing 0.04
unset key
set xrange [0.9:2e6]; set xtics 1,100
set xlabel "operations a particle"; set ylabel "fraction missing, $\\phi(\\infty)-\\phi$" offset 2.2,0
set arrow 1 from full(2),2.5e-3 to full(2),9e-4 lt Discs lw 1.5 size graph 0.02,25
set arrow 2 from full(3),2.5e-3 to full(3),9e-4 lt Spheres lw 1.5 size graph 0.02,25
set label 1 ink(Guide, "one by one") at 1e4,0.04; set label 2 ink(Guide, "ours") at 2.5,6e-3
plot work("naive", 2) using ops:"missing fraction" with lines lt Discs dt 2, work("naive", 3) using ops:"missing fraction" with lines lt Spheres dt 2, \
  work("ours", 2) using ops:"missing fraction" with linespoints lt Discs, work("ours", 3) using ops:"missing fraction" with linespoints lt Spheres
unset label
unset ylabel; set format y ""
set xrange [3e-8:2e-2]; set xtics 1e-7,10; set xlabel "seconds a particle"
set arrow 1 from saturated("discs"),2.5e-3 to saturated("discs"),9e-4 lt Discs lw 1.5 size graph 0.02,25
set arrow 2 from saturated("spheres"),2.5e-3 to saturated("spheres"),9e-4 lt Spheres lw 1.5 size graph 0.02,25
set label 1 ink(Discs, "discs") at saturated("discs")*0.8,1.4e-3 right; set label 2 ink(Spheres, "spheres") at saturated("spheres")*1.3,1.4e-3
plot rows("plain_trials", "discs") using (each(1)):"error":(each_err(1)) with xerrorlines lt Discs pt 6 dt 2, \
  rows("plain_trials", "spheres") using (each(1)):"error":(each_err(1)) with xerrorlines lt Spheres pt 4 dt 2, \
  rows("ours", "discs") using (each(1)):"error":(each_err(1)) with xerrorlines lt Discs, \
  rows("ours", "spheres") using (each(1)):"error":(each_err(1)) with xerrorlines lt Spheres
unset multiplot
