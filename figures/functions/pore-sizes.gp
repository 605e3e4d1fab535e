# E_V(r) of penetrable and of hard discs and spheres, with the laws.
# data: voids-discs voids-spheres voids-hard-discs voids-hard-spheres
free(x,e,n,d) = (1 - e*(1 + x)**d/n)**n
plane(x,p) = x < 0 ? 1 - p*(1 + x)**2 : (1 - p)*exp(-2*p*x/(1 - p) - p*x**2/(1 - p)**2)
space(x,p) = x < 0 ? 1 - p*(1 + x)**3 : (1 - p)*exp(-3*p*x/(1 - p) - (3*p/(1 - p) + 4.5*p**2/(1 - p)**2)*x**2 - p*(1 + p + p**2)/(1 - p)**3*x**3)
set logscale y; set format y "$10^{%T}$"; set yrange [2e-6:1.3]; set xrange [-0.6:3.1]
set xlabel "$R=r/a$"; set ylabel "$E_V$" offset 1
set key inside bottom left vertical Left reverse samplen 1.5
plot data("voids-discs", "E_V.tsv") using "R":"E":"E_err" with yerrorbars lt Discs pt 6 ps 0.5 title "penetrable discs", \
  data("voids-spheres", "E_V.tsv") using "R":"E":"E_err" with yerrorbars lt Spheres pt 4 ps 0.5 title "penetrable spheres", \
  data("voids-hard-discs", "shaken.E_V.tsv") using "R":"E":"E_err" with yerrorbars lt Discs ps 0.45 title "hard discs", \
  data("voids-hard-spheres", "shaken.E_V.tsv") using "R":"E":"E_err" with yerrorbars lt Spheres ps 0.4 title "hard spheres", \
  [-0.5:3] free(x,0.5,200,2) with lines lt Discs dt 2 notitle, [-0.5:2] free(x,0.5,400,3) with lines lt Spheres dt 2 notitle, \
  [-0.5:3] plane(x,0.4) with lines lt Discs notitle, [-0.5:2] space(x,0.3) with lines lt Spheres notitle
