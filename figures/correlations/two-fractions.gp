# S Figs. 7 c and d: S_aa of superellipses, m = 2, at .1 to .8, without overlap and with; beside the law of grains.
# data: two-hard two-penetrable
set terminal cairolatex pdf size 12.6cm,7.2cm font ",10" fontscale 0.9
set output out
curve(s, k) = data("two-".s, sprintf("S2@0.%d.tsv", k))
set multiplot
unset key
set tmargin screen 0.97; set bmargin screen 0.16
set xrange [0:6]; set xtics 1; set yrange [0:0.82]; set ytics 0.2; set mytics 2
set xlabel "$R=r/a$" offset 0,0.4
set arrow 1 from 2,0 to 2,0.82 nohead lt Guide lw 0.6 back
set lmargin screen 0.1; set rmargin screen 0.52
set label 9 "$S_{aa}$" at screen 0.012,graph 0.5 center rotate
set label 1 "without overlap" at 5.9,0.78 right
set label 2 ink(Guide, "$D_{eq}$") at 2.1,0.705
do for [k = 1:8] { set label 10 + k sprintf("\\small$.%d$", k) at 6.1,0.01*k*k + (k == 1 ? -0.01 : k == 2 ? 0.006 : 0) }
plot for [k = 1:8] curve("hard", k) using "R":"S2":"S2_err" with yerrorlines lt 1 ps 0.15 lw 0.8
unset label 9; unset label 2
set lmargin screen 0.57; set rmargin screen 0.96; set format y ""
set label 1 "may overlap; lines: the law" at 5.9,0.78 right
plot for [k = 1:8] data("two-penetrable", sprintf("boolean@0.%d.tsv", k)) using "R":"S2_phi" with lines lt Law lw 0.8, \
  for [k = 1:8] curve("penetrable", k) using "R":"S2":"S2_err" every 2 with yerrorbars lt 2 pt 4 ps 0.3 lw 0.8
unset multiplot
