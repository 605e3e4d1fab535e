# Percus-Yevick at several fractions, with Willis and the well-stirred line.
# data: theory-curves
set multiplot layout 2,1 margins screen 0.09,0.97,0.12,0.98 spacing screen 0.10
set xrange [2:6]; set yrange [0:3.2]; set ylabel "$g(R)$"
set key top right
f = data("theory-curves", "theory.tsv")
plot f using "R":"py_0.6" with lines lt 4 title "PY, $\\phi=.6$", f using "R":"py_0.575" with lines lt 1 title ".575", \
  f using "R":"py_0.49" with lines lt 3 title ".49", f using "R":"py_0.3" with lines lt 5 title ".3", f using "R":"py_0.1" with lines lt 6 title ".1", \
  f using "R":"well-stirred_0.575" with lines lt 8 title "well-stirred"
set xlabel "$R=r/a$"; set yrange [0:7.4]; set xrange [2:6]
set arrow from 2,1 to 6,1 nohead lt 8
plot f using "R":"py_0.575" with lines lt 1 title "PY, $\\phi=.575$", f using "R":"willis_0.575" with lines lt 2 title "Willis", \
  f using "R":"willis-kanaun_0.575" with lines lt 3 dt 3 title "Willis--Kanaun"
unset multiplot
