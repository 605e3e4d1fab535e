# How RSA approaches saturation: phi(infinity) - phi(t) against time.
# data: rsa-saturation-2d rsa-saturation-3d
stats data("rsa-saturation-2d", "approach.tsv") using (column("phi")) nooutput name "D"
stats data("rsa-saturation-3d", "approach.tsv") using (column("phi")) nooutput name "S"
set logscale xy; set format x "$10^{%T}$"; set format y "$10^{%T}$"
set xrange [0.3:1e9]; set yrange [1e-5:1]
set xlabel "time $t$, attempts $\\times\\,v/V$"; set ylabel "$\\phi(\\infty)-\\phi(t)$" offset 0.5
set key inside bottom left vertical Left reverse
plot data("rsa-saturation-3d", "approach.tsv") every 2 using "t":(S_max - column("phi")) with points lt Spheres title "spheres", \
  data("rsa-saturation-2d", "approach.tsv") every 2 using "t":(D_max - column("phi")) with points lt Discs title "discs", \
  0.3*x**(-1./3) with lines lt Guide title "slopes $-1/3$, $-1/2$", 0.3*x**(-1./2) with lines lt Guide notitle
