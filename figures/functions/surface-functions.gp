# F_sv and F_ss over their values far away, with the laws of penetrable particles.
# data: voids-discs voids-spheres voids-hard-discs voids-hard-spheres
s2 = 2*0.5*(1 - 0.5/200)**199; m2 = (1 - 0.5/200)**200; s3 = 3*0.5*(1 - 0.5/400)**399; m3 = (1 - 0.5/400)**400
# parts outside, and of two unit balls together over one
p2(r) = r < 2 ? 1 - acos(r/2)/pi : 1
p3(r) = r < 2 ? 0.5 + r/4 : 1
v2(r) = r < 2 ? 2 - 2*(acos(r/2) - r/2*sqrt(1 - r*r/4))/pi : 2
v3(r) = r < 2 ? 2 - (1 - r/2)**2*(1 + r/4) : 2
d2(r) = r < 2 ? 1/(pi*r*sqrt(1 - r*r/4)) : 0
d3(r) = r < 2 ? 1/(2*r) : 0
sv2(r) = 2*0.5*p2(r)*(1 - 0.5*v2(r)/200)**199/(s2*m2)
sv3(r) = 3*0.5*p3(r)*(1 - 0.5*v3(r)/400)**399/(s3*m3)
ss2(r) = (p2(r)**2*(1 - 1./200)*(1 - 0.5*v2(r)/200)**198 + d2(r)*(1 - 0.5*v2(r)/200)**199)/s2**2
ss3(r) = (9*0.25*p3(r)**2*(1 - 1./400)*(1 - 0.5*v3(r)/400)**398 + 3*0.5*d3(r)*(1 - 0.5*v3(r)/400)**399)/s3**2
set multiplot
set xrange [0:4.05]; set samples 801
set xlabel "$R=r/a$"; set xtics 1
set lmargin screen 0.11; set rmargin screen 0.52; set bmargin screen 0.15; set tmargin screen 0.97
set yrange [0.5:1.15]; set label 1 "$F_{sv}/s(1-\\phi)$" at screen 0.015,graph 0.5 center rotate
set key inside bottom right vertical Right
plot data("voids-discs", "F_sv.tsv") using "R":(column("F")/s2/m2):(column("F_err")/s2/m2) every 2 with yerrorbars lt Discs pt 6 ps 0.5 title "penetrable discs", \
  data("voids-spheres", "F_sv.tsv") using "R":(column("F")/s3/m3):(column("F_err")/s3/m3) every 2 with yerrorbars lt Spheres pt 4 ps 0.5 title "penetrable spheres", \
  data("voids-hard-discs", "shaken.F_sv.tsv") using "R":(column("F")/0.8/0.6):(column("F_err")/0.8/0.6) every 2 with yerrorlines lt Discs ps 0.4 title "hard discs", \
  data("voids-hard-spheres", "shaken.F_sv.tsv") using "R":(column("F")/0.9/0.7):(column("F_err")/0.9/0.7) every 2 with yerrorlines lt Spheres ps 0.35 title "hard spheres", \
  [0:4] sv2(x) with lines lt Discs dt 2 notitle, [0:4] sv3(x) with lines lt Spheres dt 2 notitle
set lmargin screen 0.65; set rmargin screen 0.98
set yrange [0:3.5]; set label 1 "$F_{ss}/s^2$" at screen 0.572,graph 0.5 center rotate
unset key
plot data("voids-discs", "F_ss.tsv") using "R":(column("F")/s2**2):(column("F_err")/s2**2) with yerrorbars lt Discs pt 6 ps 0.5, \
  data("voids-spheres", "F_ss.tsv") using "R":(column("F")/s3**2):(column("F_err")/s3**2) with yerrorbars lt Spheres pt 4 ps 0.5, \
  data("voids-hard-discs", "shaken.F_ss.tsv") using "R":(column("F")/0.8**2):(column("F_err")/0.8**2) with yerrorlines lt Discs ps 0.4, \
  data("voids-hard-spheres", "shaken.F_ss.tsv") using "R":(column("F")/0.9**2):(column("F_err")/0.9**2) with yerrorlines lt Spheres ps 0.35, \
  [0.02:4] ss2(x) with lines lt Discs dt 2, [0.02:4] ss3(x) with lines lt Spheres dt 2
unset multiplot
