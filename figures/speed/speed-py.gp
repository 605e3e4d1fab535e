# Percus-Yevick at phi = .575: error against terms, near contact, midway and far.
# data: build/data/speed/summary.tsv
rows(m, R) = columns(sprintf("'where=method=%s;phi=0.575;R=r/a=%s' build/data/speed/py.tsv", m, R))
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [0.6:1e6]; set yrange [4e-16:3]
set xtics 1,100,1e4; set ytics 1e-15,1e3,1
set mxtics 1; set mytics 1
unset key
set multiplot layout 1,3 margins 0.135,0.985,0.17,0.91 spacing 0.03
do for [k = 1:3] {
  R = word("2.1 5 15", k)
  set title "$R=".R."$" offset 0,-0.8
  if (k == 2) { set format y "" }
  set xlabel (k == 2 ? "terms, or points of the grid" : " ")
  unset label
  if (k == 1) { set label "error of $g$" at screen 0.02,graph 0.5 center rotate }
  if (k == 1) { set label ink(4, "poles") at 1,0.01; set label ink(3, "shells") at 5,6e-15 }
  if (k == 2) { set label ink(Plain, "Fourier, plain") at 300,0.5 }
  if (k == 3) { set label ink(5, "jump") at 1.2e4,1e-9 right; set label ink(5, "subtracted") at 1.2e4,4e-11 right }
  plot rows("fft-plain", R) using "terms":"absolute error" with linespoints lt Plain, \
    rows("fft", R) using "terms":"absolute error" with linespoints lt 5, \
    rows("poles", R) using "terms":"absolute error" with linespoints lt 4, \
    rows("shells", R) using "terms":"absolute error" with points lt 3 ps 1
}
unset multiplot
