# The nearest gap of a diluted pack for several ranges of the moves, in both readings.
# data: dilute
set terminal cairolatex pdf size 12.6cm,7cm font ",10" fontscale 0.9
set output out
law(f, r, p) = data("dilute", sprintf("nearest@%s@%s@%s.tsv", f, r, p))
gap(R) = (R - 2)/2
set multiplot
unset key
set tmargin screen 0.96; set bmargin screen 0.18
mean(f) = gap(known("dilute", "nearest@".f."@surfaces@0"))
do for [i = 0:1] {
  f = word("0.5 0.3", i + 1); m = mean(f)
  set lmargin screen 0.1 + 0.46*i; set rmargin screen 0.51 + 0.46*i
  set xrange [0:0.14 + 0.28*i]; set xtics 0.05*(1 + i); set logscale y; set yrange [0.3:300]; set format y "$10^{%T}$"
  set xlabel "nearest gap, diameters"; if (i) { set format y "" }
  unset label
  if (!i) { set label 9 "density of gaps, by diameters" at screen 0.013,graph 0.5 center rotate }
  set arrow 1 from m,0.3 to m,130 nohead lt 1 front
  set label 2 ink(1, "no moves") at m,200 center
  if (i) {
    set label 1 "$\\phi=.3$" at graph 0.97,0.84 right
    set label 3 ink(2, "surfaces, $\\frac12R_\\phi$") at 0.205,28 right; set label 4 ink(3, "surfaces, $R_\\phi$") at 0.268,5
    set label 5 ink(5, "centres, $\\frac12R_\\phi$") at 0.283,1; set label 6 ink(4, "$\\scriptstyle\\blacklozenge$ centres, $R_\\phi$") at 0.035,90
  } else { set label 1 "$\\phi=.5$" at graph 0.97,0.95 right }
  plot law(f, "surfaces", "0.5") using (gap(column("R"))):(2*column("H")):(2*column("H_err")) with yerrorlines lt 2 lw 1 pt 5 ps 0.4, \
    law(f, "surfaces", "1") using (gap(column("R"))):(2*column("H")):(2*column("H_err")) with yerrorlines lt 3 lw 1 dt 2 pt 9 ps 0.45, \
    law(f, "centres", "0.5") using (gap(column("R"))):(2*column("H")):(2*column("H_err")) with yerrorlines lt 5 lw 1 dt 3 pt 11 ps 0.45, \
    law(f, i ? "centres" : "surfaces", "1") using (gap(column("R"))):(2*column("H")):(2*column("H_err")) with yerrorlines lt (i ? 4 : 3) lw 1 dt 0 + (i ? 4 : 2) pt (i ? 13 : 9) ps 0.45
}
unset multiplot
