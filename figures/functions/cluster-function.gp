# C_2 of penetrable discs beside S_2.
# data: cluster-discs
shared(r) = r < 2 ? 2*(acos(r/2) - r/2*sqrt(1 - r*r/4))/pi : 0
s2(r,p) = 2*p - 1 + (1 - p)**2*exp(-log(1 - p)*shared(r))
set xrange [0:12.2]; set yrange [0:0.86]; set ytics 0.2; set mytics 2
set xlabel "$R=r/a$"; set ylabel "$C_2$ (points), $S_2$ (lines)" offset 1
unset key
set label 1 ink(1, "$\\phi=.3$") at 11.9,0.12 right; set label 2 ink(2, "$.55$") at 11.9,0.335 right
set label 3 ink(3, "$.6763$") at 11.9,0.49 right; set label 4 ink(4, "$.8$") at 11.9,0.67 right
plot data("cluster-discs", "C2@0.3.tsv") using "R":"C2":"C2_err" with yerrorbars lt 1 pt 7 ps 0.3, \
  data("cluster-discs", "C2@0.55.tsv") using "R":"C2":"C2_err" with yerrorbars lt 2 pt 5 ps 0.3, \
  data("cluster-discs", "C2@0.6763.tsv") using "R":"C2":"C2_err" with yerrorbars lt 3 pt 9 ps 0.35, \
  data("cluster-discs", "C2@0.8.tsv") using "R":"C2":"C2_err" with yerrorbars lt 4 pt 13 ps 0.35, \
  [0:12] s2(x,0.3) with lines lt 1, [0:12] s2(x,0.55) with lines lt 2, \
  [0:12] s2(x,0.6763) with lines lt 3, [0:12] s2(x,0.8) with lines lt 4
