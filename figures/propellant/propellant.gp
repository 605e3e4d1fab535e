# Two sizes: the fraction at which they jam, over the coarse share; and the highest of each ratio, down to no size.
# data: propellant propellant-one propellant-optimum
set terminal cairolatex pdf size 12.6cm,8.6cm font ",10" fontscale 0.9
best(q) = known("propellant-optimum", q)
curve(r) = columns(sprintf("where=species.[1].radius=%s %s", r, data("propellant", "sweep.tsv")))
# the coarse share, of the volumes of coarse and fine
share(fine) = column("species.[0].volume")/(fine + column("species.[0].volume"))
flat(r, c) = real(word(system(sprintf("awk -f figures/tools/columns.awk 'get=%s' 'where=species.[1].radius=%s' %s", c, r, data("propellant", "sweep.tsv"))), 1))
maxima = columns("'of=X@*' ".data("propellant-optimum", "summary.tsv")." 'of=fraction@*' ".data("propellant-optimum", "summary.tsv"))
$Maggi << END
X	phi
0.75	0.731
0.90	0.687
END
$bound << END
size	phi
0	0.8686
END
sizes = "0.667 0.477 0.313 0.2 0.1538"; names = "1.5:1 2.1:1 3.2:1 5:1 6.5:1"; points = "9 5 7 13 11"
phi0 = best("one_size"); top = best("furnas"); best_layer = best("layer")
coarse(X) = phi0/X; fine(X, r) = phi0/(1 - X*(1 - phi0*(1 + 6*best_layer*r)))
set multiplot
set lmargin screen 0.115; set rmargin screen 0.60; set tmargin screen 0.97; set bmargin screen 0.14
unset key
set xrange [0.2:1]; set yrange [0.62:0.89]; set xtics 0.2; set mxtics 2; set ytics 0.05 format "%.2f"; set mytics 5
set xlabel "coarse share of the volume, $X$"; set label 9 "$\\phi$ at jamming" at screen 0.02,graph 0.5 center rotate
set label 1 ink(Guide, "Furnas") at 0.59,0.828 right
set label 2 "B: $.868$" at 0.215,0.878
set arrow 1 from 0.2,0.868 to 1,0.868 nohead lt Source dt 3 lw 0.8
set label 3 "triangles:" at 0.785,0.848; set label 4 "Maggi, 6.5:1" at 0.785,0.832
# the flat curves are named at their first points, the others where there is room
do for [i = 1:3] { r = word(sizes, i)
  set label 10 + i ink(i, word(names, i)) at flat(r, "species.[0].volume")/(1 + flat(r, "species.[0].volume")) - 0.015,flat(r, "fraction") right }
set label 14 ink(4, word(names, 4)) at 0.555,0.727
set label 15 ink(5, word(names, 5)) at 0.63,0.787 right
plot [0.2:1] (x < 1/(2 - phi0) ? fine(x, 0) : coarse(x)) with lines lt Guide lw 1.4, \
  for [i = 3:5] (fine(x, word(sizes, i)) < coarse(x) ? fine(x, word(sizes, i)) : NaN) with lines lt i lw 0.8 dt 3, \
  for [i = 1:5] curve(word(sizes, i)) using (share(1)):"fraction":"fraction_err" with yerrorlines lt i pt int(word(points, i)) ps 0.55 lw 1.1, \
  maxima using (column("standard_error") < 0.05 ? column("value") : NaN):"value_2":"standard_error" with xerrorbars lt Source pt 1 ps 0.9 lw 1.2, \
  $Maggi using "X":"phi" with points lt Source pt 10 ps 1.1 lw 1.6
unset label; unset arrow
set lmargin screen 0.745; set rmargin screen 0.985
set xrange [0:0.7]; set xtics 0.2 format "%g"; set format y "%.2f"
set xlabel "size, fine to coarse"; set label 9 "highest $\\phi$ at jamming" at screen 0.645,graph 0.5 center rotate
slope = best("slope"); far = best("fraction@0")
set label 1 ink(Guide, "Furnas") at 0.05,top
plot [0:0.7] (x < 0.36 ? far - slope*x : NaN) with lines lt Source dt 2 lw 0.9, \
  maxima using "at":"value_2":"standard_error_2" with yerrorbars lt Source pt 7 ps 0.6, \
  $bound using "size":"phi" with points lt Guide pt 2 ps 1.2 lw 1.6 dt 1
unset multiplot
