# Two sizes: the fraction at which they jam, over the coarse share; and the highest of each ratio, down to no size.
# data: propellant propellant-one propellant-optimum
set terminal cairolatex pdf size 12.6cm,8.6cm font ",10" fontscale 0.9
best(q) = real(system(sprintf("awk -F'\\t' '$1==\"%s\" {print $2}' %s", q, data("propellant-optimum", "summary.tsv"))))
curve(r) = sprintf("< awk -F'\\t' '/^#/ {next} !h++ || $1==%s' %s", r, data("propellant", "sweep.tsv"))
first_of(r, k) = real(system(sprintf("awk -F'\\t' '/^#/ {next} !h++ {for (i = 1; i <= NF; i++) if ($i==\"fraction\") c = i; next} $1==%s {print %d ? $c : $2/(1 + $2); exit}' %s", r, k, data("propellant", "sweep.tsv"))))
maxima = "< awk -F'\\t' '{split($1, a, \"@\"); v[$1] = $2; e[$1] = $3; if (a[1]==\"X\" && a[2] > 0) r[n++] = a[2]} END {for (i = 0; i < n; i++) print r[i] \"\\t\" v[\"X@\" r[i]] \"\\t\" e[\"X@\" r[i]] \"\\t\" v[\"fraction@\" r[i]] \"\\t\" e[\"fraction@\" r[i]]}' ".data("propellant-optimum", "summary.tsv")
sizes = "0.667 0.477 0.313 0.2 0.1538"; names = "1.5:1 2.1:1 3.2:1 5:1 6.5:1"; points = "9 5 7 13 11"
phi0 = best("one_size"); top = best("furnas"); best_layer = best("layer")
coarse(X) = phi0/X; fine(X, r) = phi0/(1 - X*(1 - phi0*(1 + 6*best_layer*r)))
set multiplot
set lmargin screen 0.10; set rmargin screen 0.63; set tmargin screen 0.97; set bmargin screen 0.14
unset key
set xrange [0.2:1]; set yrange [0.62:0.89]; set xtics 0.2; set mxtics 2; set ytics 0.05 format "%.2f"; set mytics 5
set xlabel "coarse share of the volume, $X$"; set ylabel "$\\phi$ at jamming" offset 1.2,0
set label 1 ink(8, "Furnas") at 0.59,0.828 right
set label 2 "B: $.868$" at 0.215,0.878
set arrow 1 from 0.2,0.868 to 1,0.868 nohead lt 7 dt 3 lw 0.8
set label 3 "$\\triangledown$ Maggi, 6.5:1" at 0.785,0.835
# the flat curves are named at their first points, the others where there is room
do for [i = 1:3] { r = word(sizes, i)
  set label 10 + i ink(i, word(names, i)) at first_of(r, 0) - 0.015,first_of(r, 1) right }
set label 14 ink(4, word(names, 4)) at 0.555,0.727
set label 15 ink(5, word(names, 5)) at 0.63,0.787 right
plot [0.2:1] (x < 1/(2 - phi0) ? fine(x, 0) : coarse(x)) with lines lt 8 lw 1.4, \
  for [i = 3:5] (fine(x, word(sizes, i)) < coarse(x) ? fine(x, word(sizes, i)) : NaN) with lines lt i lw 0.8 dt 3, \
  for [i = 1:5] curve(word(sizes, i)) using ($2/(1 + $2)):"fraction":"fraction_err" with yerrorlines lt i pt int(word(points, i)) ps 0.55 lw 1.1, \
  maxima using ($3 < 0.05 ? $2 : NaN):4:3 with xerrorbars lt 7 pt 1 ps 0.9 lw 1.2, \
  "-" using 1:2 with points lt 7 pt 10 ps 1.1 lw 1.6
0.75	0.731
0.90	0.687
e
unset label; unset arrow
set lmargin screen 0.70; set rmargin screen 0.985
set xrange [0:0.7]; set xtics 0.2 format "%g"; set format y ""; unset ylabel; set format x "%g"
set xlabel "size, fine to coarse"
slope = best("slope"); far = best("fraction@0")
set label 1 ink(8, "Furnas") at 0.05,top
set label 2 "highest $\\phi$" at 0.3,0.735
plot [0:0.7] (x < 0.36 ? far - slope*x : NaN) with lines lt 7 dt 2 lw 0.9, \
  maxima using 1:4:5 with yerrorbars lt 7 pt 7 ps 0.6, \
  "-" using 1:2 with points lt 8 pt 2 ps 1.2 lw 1.6 dt 1
0	0.8686
e
unset multiplot
