# Percus-Yevick at several fractions, with Willis and the well-stirred line.
# data: theory-curves
set terminal cairolatex pdf size 12.6cm,10.5cm font ",10"
set output out
f = data("theory-curves", "theory.tsv")
set multiplot
set lmargin screen 0.11; set rmargin screen 0.98
set xrange [2:6.2]; set label 1 "$g(R)$" at screen 0.018,graph 0.5 center rotate
set tmargin screen 0.985; set bmargin screen 0.58
set yrange [0:3.4]
set key at graph 0.99,0.99 right vertical maxrows 3
plot f using "R":"py_0.6" with lines lc rgb "#000000" lw 1.8 title "$\\phi=.6$", f using "R":"py_0.575" with lines lt Py lw 1.6 title "$.575$", \
  f using "R":"py_0.49" with lines lc rgb "#0072b2" lw 1.6 dt 2 title "$.49$", f using "R":"py_0.3" with lines lc rgb "#0072b2" lw 1.4 title "$.3$", f using "R":"py_0.1" with lines lc rgb "#3a94c8" lw 2 dt 3 title "$.1$", \
  f using "R":"well-stirred_0.575" with lines lt Guide title "well-stirred"
set tmargin screen 0.49; set bmargin screen 0.11
set xlabel "$R=r/a$"; set yrange [0:7.4]
plot f using "R":"py_0.575" with lines lt Py title "Percus--Yevick, $\\phi=.575$", f using "R":"willis_0.575" with lines lt Willis title "Willis", \
  f using "R":"willis-kanaun_0.575" with lines lt 13 dt 2 title "Willis--Kanaun", f using "R":"well-stirred_0.575" with lines lt Guide notitle
unset multiplot
