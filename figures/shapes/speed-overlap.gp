# Error of an overlap area against microseconds a pair: points of a lattice, polygons of 16, 64 and 256 nodes, and exact areas.
# data: speed data/bench-seconds.tsv
set terminal cairolatex pdf size 12.6cm,7.2cm font ",10" fontscale 0.9
set output out
# A number such as 2e-05 is none to gnuplot.
known(scene, q) = real(system(sprintf("awk -f figures/tools/columns.awk get=value 'where=quantity=%s' %s | sed 's/^\\([0-9]*\\)e/\\1.0e/'", q, data(scene, "summary.tsv"))))
wrong(f, m, n) = known("speed", sprintf("overlap_%s_%s_%d", f, m, n))
took(f, m) = 1e6*spent(sprintf("task=overlap;method=%s;case=%s", m, f))
points(f, k) = wrong(f, "points", 10**(4 + int(k))); ptime(f, k) = took(f, word("points-10000 points-100000 plain-points", int(k) + 1))
mixed(f, k) = wrong(f, "mixed", 16*4**int(k)); mtime(f, k) = took(f, word("mixed-16 mixed mixed-256", int(k) + 1))
ms = "1 1.5 2 5 50"; aspects = "1 1.5 5"
$sizes << EOD
k
0
1
2
EOD
set multiplot
unset key
set tmargin screen 0.9; set bmargin screen 0.16
set logscale xy; set format x "$10^{%T}$"; set xrange [0.02:3e5]; set yrange [1e-17:1e-1]; set xtics 100; set ytics 1e4
do for [i = 1:3] {
  a = word(aspects, i)
  set lmargin screen 0.13 + 0.29*(i - 1); set rmargin screen 0.4 + 0.29*(i - 1)
  set format y (i == 1 ? "$10^{%T}$" : "")
  unset label
  set label 1 sprintf("$a/b=%s$", a) at graph 0.5,1.06 center
  if (i == 1) { set label 9 "error of the area" at screen 0.01,graph 0.5 center rotate }
  if (i == 2) { set xlabel "microseconds a pair, one core" } else { set xlabel " " }
  if (i == 3) {
    do for [j = 1:5] { set label 10 + j ink(j, "$m=".word(ms, j)."$") at graph 0.98,0.53 - 0.075*j right }
    set label 20 ink(Law, "pentagons") at graph 0.98,0.075 right
  }
  plot for [j = 1:5] $sizes using (ptime(a."-".word(ms, j), column("k"))):(points(a."-".word(ms, j), column("k"))) with linespoints lt j lw 0.8 dt j pt 6 ps 0.6, \
    for [j = 1:5] $sizes using (mtime(a."-".word(ms, j), column("k"))):(mixed(a."-".word(ms, j), column("k"))) with linespoints lt j lw 0.8 dt j pt 4 ps 0.6, \
    for [j = 1:5] "+" using (took(a."-".word(ms, j), "ours")):(known("speed", sprintf("overlap_%s-%s_ours", a, word(ms, j)))) every ::0::0 with points lt j pt 7 ps 0.8, \
    $sizes using (ptime("pentagon", column("k"))):(points("pentagon", column("k"))) with linespoints lt Law lw 0.8 pt 6 ps 0.6, \
    "+" using (took("pentagon", "ours")):(known("speed", "overlap_pentagon_ours")) every ::0::0 with points lt Law pt 7 ps 0.8
}
unset multiplot
