# The pressure of few spheres, with the correction that fixed numbers ask for; and of discs, against Henderson's.
# data: growth-size growth-discs growth-theory
Z(phi) = equation("schultz", phi, "Z")
q(phi) = phi*(Z(phi) - 1)
h = 1e-3
# Z_N - Z = -phi q''/2N(1 + q'), q = phi (Z - 1)
slope(phi) = -phi*(q(phi + h) - 2*q(phi) + q(phi - h))/h**2/2/(1 + (q(phi + h) - q(phi - h))/2/h)
rows(phi) = columns(sprintf("where=fraction=%g %s", phi, data("growth-size", "sweep.tsv")))
discs = data("growth-discs", "sweep.tsv")
henderson(phi) = equation("henderson-discs", phi, "Z")
set multiplot
set lmargin screen 0.125; set rmargin screen 0.53; set tmargin screen 0.97; set bmargin screen 0.18
unset key
set xrange [0:0.066]; set xtics 0.02; set yrange [-25:5]
set xlabel "$1/N$"; set ylabel "$Z_N/Z_{\\rm Schultz}-1$, per mille" offset 1,0
set label 1 ink(1, "$\\phi=.1$") at 0.041,-18; set label 2 ink(2, "$.3$") at 0.058,-2; set label 3 ink(3, "$.45$") at 0.034,-21
z1 = Z(0.1); z2 = Z(0.3); z3 = Z(0.45)
s1 = slope(0.1); s2 = slope(0.3); s3 = slope(0.45)
plot 0 with lines lt Guide, 1000*s1/z1*x with lines lt 1 lw 0.8, 1000*s2/z2*x with lines lt 2 lw 0.8, 1000*s3/z3*x with lines lt 3 lw 0.8, \
  rows(0.1) using (1/column("number")):(1000*(column("Z")/z1 - 1)):(1000*column("Z_err")/z1) with yerrorbars lt 1 ps 0.5, \
  rows(0.3) using (1/column("number")):(1000*(column("Z")/z2 - 1)):(1000*column("Z_err")/z2) with yerrorbars lt 2 ps 0.5, \
  rows(0.45) using (1/column("number")):(1000*(column("Z")/z3 - 1)):(1000*column("Z_err")/z3) with yerrorbars lt 3 ps 0.6
set lmargin screen 0.675; set rmargin screen 0.985
set xrange [0:0.74]; set xtics 0.2; set yrange [-13:5]; set ytics 5
set xlabel "$\\phi$ (discs)"; set ylabel "$Z/Z_{\\rm Henderson}-1$, per cent" offset 1.6,0
unset label
set arrow 1 from 0.7,-13 to 0.7,5 nohead lt Guide
set label 1 ink(Guide, "freezing") at 0.69,-11.5 right
plot 0 with lines lt Guide, discs using "fraction":(100*(column("Z")/henderson(column("fraction")) - 1)):(100*column("Z_err")/henderson(column("fraction"))) with yerrorlines lt 1 ps 0.5
unset multiplot
