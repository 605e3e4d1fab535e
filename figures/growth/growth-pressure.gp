# The pressure by collisions: against Schultz's fit in the fluid; against Carnahan and Starling's beyond freezing.
# data: growth-pressure growth-metastable growth-theory
# the equations on a grid of fractions, in a file; one over another
grid(from, to, step) = system(sprintf("seq -s, %g %g %g", from, step, to))
eos = out.".eos"
system(theory(grid(0.01, 0.57, 0.002))." > ".eos)
ratio(a, b, to) = columns(sprintf("by=phi 'where=equation=%s;phi<%g' %s 'where=equation=%s' %s", a, to, eos, b, eos))
Z(name) = equation(name, column("fraction"), "Z")
# N (Z_N - Z) = -phi q''/2(1 + q'), q = phi (Z - 1)
q(phi) = phi*(equation("schultz", phi, "Z") - 1)
h = 1e-3
finite(phi) = -phi*(q(phi + h) - 2*q(phi) + q(phi - h))/h**2/2/(1 + (q(phi + h) - q(phi - h))/2/h)
permille(r) = 1000*(r - 1)
percent(r) = 100*(r - 1)
long(warm) = columns(sprintf("where=measure.pressure.warm=%s %s", warm, data("growth-metastable", "sweep.tsv")))
set multiplot
set lmargin screen 0.125; set rmargin screen 0.535; set tmargin screen 0.97; set bmargin screen 0.18
set xrange [0:0.51]; set xtics 0.1; set yrange [-3.3:1.7]
set xlabel "$\\phi$"; set ylabel "$Z/Z_{\\rm Schultz}-1$, per mille" offset 0.8,0
unset key
set label 1 ink(2, "Carnahan--Starling") at 0.02,-3.05
set label 2 ink(4, "Hansen-Goos, KLM") at 0.02,1.35
plot 0 with lines lt Guide, ratio("carnahan-starling", "schultz", 0.491) using "phi":(permille(over("Z"))) with lines lt 2, \
  ratio("hansen-goos", "schultz", 0.491) using "phi":(permille(over("Z"))) with lines lt 4, \
  ratio("klm", "schultz", 0.491) using "phi":(permille(over("Z"))) with lines lt 4 dt 2, \
  data("growth-pressure", "sweep.tsv") using "fraction":(permille((column("Z") - finite(column("fraction"))/1000)/Z("schultz"))):(1000*column("Z_err")/Z("schultz")) with yerrorbars lt 1 ps 0.5
set lmargin screen 0.655; set rmargin screen 0.985
set xrange [0.485:0.57]; set xtics 0.02; set yrange [-1:10]
set ylabel "$Z/Z_{\\rm CS}-1$, per cent" offset 1,0
unset label
set label 1 ink(1, "50") at 0.555,7.8 right; set label 2 ink(3, "800") at 0.557,2.9 right
set label 3 ink(Guide, "collisions a particle:") at 0.488,9.3
set label 4 ink(Law, "Schultz") at 0.538,-0.45 right
plot 0 with lines lt Guide, ratio("schultz", "carnahan-starling", 0.5505) using "phi":(percent(over("Z"))) with lines lt Law, \
  for [i = 1:2] long(word("50 800", i)) using "fraction":(percent(column("Z")/Z("carnahan-starling"))):(100*column("Z_err")/Z("carnahan-starling")) with yerrorbars lt 2*i - 1 pt 0, \
  for [i = 1:2] long(word("50 800", i)) using "fraction":(percent(column("Z")/Z("carnahan-starling"))):(2*i + (column("solid_fraction_after") > 0.02 ? 4 : 5)) with points lt 2*i - 1 pt variable ps 0.6
unset multiplot
