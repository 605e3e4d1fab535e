# Does K jump at contact? Neighbours nearer than R, in three steps, and the jump extrapolated from each.
# data: jump-grown jump-lattice jump-jammed rsa-K
set terminal cairolatex pdf size 12.6cm,7.6cm font ",10"
set output out
hs = "0.0001 0.001 0.01"
density(phi) = 3*phi/(4*pi)
grown = density(0.575); cubic = density(known("jump-lattice", "fraction@0.01"))
jammed = density(known("jump-jammed", "fraction")); rsa = density(0.3)
# the first ten steps h of a table of K: nearer than R - 2
step(h) = abs((column("R") - 2)/h - int((column("R") - 2)/h + 0.5)) < 1e-3 && column("R") < 2 + 10.5*h && column("R") > 2 + h/2 ? column("R") - 2 : NaN
near(h) = real(system(sprintf("awk -f figures/tools/columns.awk get=K 'where=R>%.9g;R<%.9g' %s", 2 + 0.99*h, 2 + 1.01*h, data("jump-jammed", "K.tsv"))))
jump(h) = 2*near(h) - near(2*h)
unset key
set multiplot
set tmargin screen 0.975; set bmargin screen 0.135
set lmargin screen 0.125; set rmargin screen 0.55
set logscale xy; set xrange [8e-5:0.125]; set yrange [4e-4:20]
set format "$10^{%T}$"
set xlabel "$R-2$"; set label 1 "$\\rho K(R)$, centres nearer than $R$" at screen 0.012,graph 0.5 center rotate
set label 2 ink(Guide, "simple cubic") at 1.1e-4,10.5
set label 3 ink(Jammed, "jammed") at 1.1e-4,2.7
set label 4 ink(Grown, "grown, $\\phi=.575$") at 3e-3,0.11
set label 5 ink(Added, "random addition, $.30$") at 1.1e-1,0.0016 right
plot for [i = 1:3] data("jump-lattice", "K@".word(hs, i).".tsv") using (step(real(word(hs, i)))):(cubic*column("K")) with lines lt Guide dt 1 lw 1.4, \
  for [i = 1:3] data("jump-jammed", "K.tsv") using (step(real(word(hs, i)))):(jammed*column("K")) with points lt Jammed pt (0 + word("8 4 6", i)) ps 0.6, \
  for [i = 1:3] data("jump-grown", "K@".word(hs, i).".tsv") using (step(real(word(hs, i)))):(grown*column("K")):(grown*column("K_err")) with yerrorbars lt Grown pt (0 + word("8 4 6", i)) ps 0.6, \
  data("rsa-K", "K.tsv") using (step(0.0005)):(rsa*column("K")):(rsa*column("K_err")) with yerrorbars lt Added pt 13 ps 0.5, \
  grown*4*pi*4*known("jump-grown", "contact@0.01")*x with lines lt Grown lw 0.7 dt 3
unset label; unset logscale y
set lmargin screen 0.675; set rmargin screen 0.985
set xrange [6e-5:1.7e-2]; set yrange [-0.8:7]; set format y "%g"; set ytics 1
set xlabel "step $\\Delta R$"; set label 1 "$\\rho\\,[2K(2{+}\\Delta R)-K(2{+}2\\Delta R)]$" at screen 0.602,graph 0.5 center rotate
set label 2 ink(Guide, "simple cubic") at 8e-5,6.4
set label 3 ink(Jammed, "jammed") at 8e-5,4.6
set label 4 ink(Grown, "grown") at 8e-5,0.33
set label 5 ink(Added, "random addition") at 8e-5,-0.42
plot 0 with lines lt Guide, \
  columns("'of=K_jump@*' ".data("jump-lattice", "summary.tsv")) using "at":(cubic*column("value")) with linespoints lt Guide dt 1 lw 1.4 pt 7, \
  "+" using (real(word(hs, int($0) + 1))):(jammed*jump(real(word(hs, int($0) + 1)))) every ::0::2 with linespoints lt Jammed pt 9 ps 0.7, \
  columns("'of=K_jump@*' ".data("jump-grown", "summary.tsv")) using "at":(grown*column("value")):(grown*column("standard_error")) with yerrorlines lt Grown ps 0.6, \
  columns("where=quantity=K_jump ".data("rsa-K", "summary.tsv")) using (0.0005):(rsa*column("value")):(rsa*column("standard_error")) with yerrorbars lt Added pt 13 ps 0.8
unset multiplot
