# S Fig. 9: S_aa of squares and of ellipses that are as round, at .5, without overlap and with, and their laws.
# data: two-polygons two-aspect two-grains two-ellipses
set terminal cairolatex pdf size 12.6cm,6.4cm font ",10" fontscale 0.9
set output out
set multiplot
unset key
set tmargin screen 0.97; set bmargin screen 0.18
set xrange [0:5]; set xtics 1; set yrange [0.2:0.41]; set ytics 0.05; set mytics 2
set xlabel "$R=r/a$" offset 0,0.4
set arrow 1 from 0,0.25 to 5,0.25 nohead lt Guide lw 0.6 back
set format y "%.2f"
set lmargin screen 0.11; set rmargin screen 0.515
set label 9 "$S_{aa}$" at screen 0.012,graph 0.5 center rotate
set label 1 "without overlap" at graph 0.96,graph 0.93 right
set label 2 ink(1, "$\\bullet$ squares") at graph 0.96,graph 0.83 right
set label 3 ink(2, "$\\scriptstyle\\blacksquare$ ellipses, $a/b=2.28367$") at graph 0.96,graph 0.74 right
plot data("two-polygons", "S2@4.tsv") using "R":"S2":"S2_err" with yerrorlines lt 1 lw 1 pt 7 ps 0.2, \
  data("two-aspect", "S2@2.28367.tsv") using "R":"S2":"S2_err" with yerrorlines lt 2 lw 1 pt 5 ps 0.2
unset label 9
set lmargin screen 0.565; set rmargin screen 0.985; set format y ""
set label 1 "may overlap; lines: the law"
plot data("two-grains", "boolean@4.tsv") using "R":"S2_phi" with lines lt 1 lw 0.6, data("two-ellipses", "boolean@2.28367.tsv") using "R":"S2_phi" with lines lt 2 lw 0.6, \
  data("two-grains", "S2@4.tsv") using "R":"S2":"S2_err" every 2 with yerrorbars lt 1 lw 1 pt 7 ps 0.25, \
  data("two-ellipses", "S2@2.28367.tsv") using "R":"S2":"S2_err" every 2 with yerrorbars lt 2 lw 1 pt 5 ps 0.25
unset multiplot
