# Does K jump at contact? Neighbours nearer than R, in three steps, and the jump extrapolated from each.
# data: jump-grown jump-lattice jump-jammed rsa-K
set terminal cairolatex pdf size 12.6cm,7.6cm font ",10"
set output out
quantity(s, q, c) = real(system(sprintf("awk -F'\\t' '$1==\"%s\" {print $%d}' %s", q, c, data(s, "summary.tsv"))))
density(phi) = 3*phi/(4*pi)
grown = density(0.575); cubic = density(quantity("jump-lattice", "fraction@0.01", 2))
jammed = density(quantity("jump-jammed", "fraction", 2)); rsa = density(0.3)
from(s, f, h) = sprintf("< awk -F'\\t' '/^#/ || !h++ {next} $1 > 2 + %g/2 && $1 < 2 + 10.5*%g {print $1 - 2 \"\\t\" $2 \"\\t\" $3}' %s", h, h, data(s, f))
wide(h) = sprintf("< awk -F'\\t' '/^#/ || !h++ {next} {k = ($1 - 2)/%g; if (k > 0.5 && k < 10.5 && (k - int(k + 0.5))^2 < 1e-6) print $1 - 2 \"\\t\" $2}' %s", h, data("jump-jammed", "K.tsv"))
jump(h) = real(system(sprintf("awk -F'\\t' '{k = ($1 - 2)/%g} (k - 1)^2 < 1e-6 {a = $2} (k - 2)^2 < 1e-6 {print 2*a - $2}' %s", h, data("jump-jammed", "K.tsv"))))
unset key
set multiplot
set tmargin screen 0.975; set bmargin screen 0.135
set lmargin screen 0.115; set rmargin screen 0.55
set logscale xy; set xrange [8e-5:0.125]; set yrange [4e-4:20]
set format "$10^{%T}$"
set xlabel "$R-2$"; set label 1 "$\\rho K(R)$, centres nearer than $R$" at screen 0.02,graph 0.5 center rotate
set label 2 ink(8, "simple cubic") at 1.1e-4,10.5
set label 3 ink(3, "jammed") at 1.1e-4,2.7
set label 4 ink(1, "grown, $\\phi=.575$") at 3e-3,0.11
set label 5 ink(4, "random addition, $.30$") at 1.1e-1,0.0016 right
plot for [h in "0.01 0.001 0.0001"] from("jump-lattice", "K@".h.".tsv", real(h)) using 1:(cubic*$2) with lines lt 8 dt 1 lw 1.4, \
  for [i = 1:3] wide(real(word("0.01 0.001 0.0001", i))) using 1:(jammed*$2) with points lt 3 pt (0 + word("6 4 8", i)) ps 0.6, \
  for [i = 1:3] from("jump-grown", "K@".word("0.01 0.001 0.0001", i).".tsv", real(word("0.01 0.001 0.0001", i))) \
    using 1:(grown*$2):(grown*$3) with yerrorbars lt 1 pt (0 + word("6 4 8", i)) ps 0.6, \
  from("rsa-K", "K.tsv", 0.0005) using 1:(rsa*$2):(rsa*$3) with yerrorbars lt 4 pt 13 ps 0.5, \
  grown*4*pi*4*quantity("jump-grown", "contact@0.01", 2)*x with lines lt 1 lw 0.7 dt 3
unset label; unset logscale y
set lmargin screen 0.675; set rmargin screen 0.985
set xrange [6e-5:1.7e-2]; set yrange [-0.8:7]; set format y "%g"; set ytics 1
set xlabel "step $\\Delta R$"; set label 1 "$\\rho\\,[2K(2{+}\\Delta R)-K(2{+}2\\Delta R)]$" at screen 0.602,graph 0.5 center rotate
set label 2 ink(8, "simple cubic") at 8e-5,6.4
set label 3 ink(3, "jammed") at 8e-5,4.6
set label 4 ink(1, "grown") at 8e-5,0.33
set label 5 ink(4, "random addition") at 8e-5,-0.42
plot 0 with lines lt 8, \
  "+" using (real(word("0.0001 0.001 0.01", int($0) + 1))):(cubic*quantity("jump-lattice", "K_jump@".word("0.0001 0.001 0.01", int($0) + 1), 2)) every ::0::2 with linespoints lt 8 dt 1 lw 1.4 pt 7, \
  "+" using (real(word("0.0001 0.001 0.01", int($0) + 1))):(jammed*jump(real(word("0.0001 0.001 0.01", int($0) + 1)))) every ::0::2 with linespoints lt 3 pt 9 ps 0.7, \
  "+" using (real(word("0.0001 0.001 0.01", int($0) + 1))):(grown*quantity("jump-grown", "K_jump@".word("0.0001 0.001 0.01", int($0) + 1), 2)):(grown*quantity("jump-grown", "K_jump@".word("0.0001 0.001 0.01", int($0) + 1), 3)) every ::0::2 with yerrorlines lt 1 pt 7 ps 0.6, \
  "+" using (0.0005):(rsa*quantity("rsa-K", "K_jump", 2)):(rsa*quantity("rsa-K", "K_jump", 3)) every ::0::0 with yerrorbars lt 4 pt 13 ps 0.8
unset multiplot
