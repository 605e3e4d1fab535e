# The error of the saturation fraction against particles placed; above, seconds.
# data: build/data/speed/summary.tsv data/bench-seconds.tsv
rows(d, n) = columns(sprintf("'where=dimension=%d;particles a pack, about=%d' build/data/speed/saturation.tsv", d, n))
placed(w) = spent(sprintf("task=rsa;case=%s-saturated;size=1000", w))
set logscale xyx2
set format x "$10^{%T}$"; set format y "$10^{%T}$"; set format x2 "$10^{%T}$"
set border 7; set xtics nomirror 100,10; set x2tics 1e-6,10,100; set mxtics 1; set mx2tics 1
set xrange [50:3e5]; set yrange [1e-4:0.03]; set ytics 1e-4,10
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.84 spacing 0.035
unset key
do for [k = 1:2] {
  s = placed(word("discs spheres", k)); width = known("speed", sprintf("rsa_%d_spread_1000", k + 1))
  set x2range [50*s:3e5*s]
  set xlabel "particles in all"; set x2label "seconds" offset 0,-0.6
  if (k == 1) { set ylabel "rms error of $\\phi(\\infty)$" offset 2.2,0 } else { unset ylabel; set format y "" }
  unset label
  set label word("discs spheres", k) at graph 0.75,0.9
  if (k == 1) {
    set label ink(1, "packs of 100") at 80,8e-4; set label ink(2, "packs of 1000") at 80,4e-4
    set label ink(3, "packs of 10000") at 80,2e-4
  }
  plot width/sqrt(x) with lines lt Guide, rows(k + 1, 100) using "particles in all":"rms error":"its error" with yerrorbars lt 1, \
    rows(k + 1, 1000) using "particles in all":"rms error":"its error" with yerrorbars lt 2, rows(k + 1, 10000) using "particles in all":"rms error":"its error" with yerrorbars lt 3
}
unset multiplot
