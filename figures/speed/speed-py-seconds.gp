# Percus-Yevick at phi = .575: the worst error over 3 <= R <= 20 against seconds.
# data: data/bench-seconds.tsv
rows(m, l) = recorded(sprintf("task=py;method=%s;case=%s", m, l))
set logscale xy
set format x "$10^{%T}$"; set format y "$10^{%T}$"
set yrange [4e-16:3]; set ytics 1e-15,1e3,1; set mxtics 1; set mytics 1
set multiplot layout 1,2 margins 0.135,0.965,0.17,0.91 spacing 0.05
unset key
do for [k = 1:2] {
  l = word("alone thousand", k)
  set title (k == 1 ? "to prepare the curve" : "for a value, then") offset 0,-0.8
  set xrange [(k == 1 ? 5e-6 : 1e-8):(k == 1 ? 1 : 1e-3)]
  if (k == 1) { set xtics 1e-5,10,0.1 } else { set xtics 1e-8,10 }
  set xlabel "seconds"
  unset label
  if (k == 1) { set label "worst error, $3\\le R\\le20$" at screen 0.02,graph 0.5 center rotate } else { set format y "" }
  if (k == 2) {
    set label ink(Plain, "Fourier, plain") at 2e-7,0.3; set label ink(5, "jump subtracted") at 1.5e-7,2e-9
    set label ink(4, "poles") at 5e-5,1e-4; set label ink(3, "shells") at 5e-6,5e-12
    set label ink(Ours, "ours") at 1e-5,8e-15
  }
  plot rows("fft-plain", l) using (each(1)):"error":(each_err(1)) with xerrorlines lt Plain, \
    rows("fft", l) using (each(1)):"error":(each_err(1)) with xerrorlines lt 5, \
    rows("poles", l) using (each(1)):"error":(each_err(1)) with xerrorlines lt 4, \
    rows("shells", l) using (each(1)):"error":(each_err(1)) with xerrorbars lt 3 ps 1, \
    rows("auto", l) using (each(1)):"error":(each_err(1)) with xerrorbars lt Ours ps 0.9
}
unset multiplot
