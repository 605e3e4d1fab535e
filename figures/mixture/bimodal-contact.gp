# Contact values of two sizes: in the fluid over those of BMCSL, and in packs at c = .6 against the ratio of the radii.
# data: bimodal-fluid bimodal bimodal-477 bimodal-138 first-peak
set terminal cairolatex pdf size 12.6cm,7.2cm font ",10" fontscale 0.9
set output out
v = "value"; e = "standard_error"
pairs = "L-L L-S S-S"; colour = "2 3 1"; full = "5 9 7"  # Coarse, Mixed, Fine
fluid(q, p, phi, c) = picked("bimodal-fluid", sprintf("%s.%s@%g", q, word(pairs, p), phi), c)
unset key
set multiplot
set bmargin screen 0.15; set tmargin screen 0.97; set lmargin screen 0.1; set rmargin screen 0.47
set xrange [0.27:0.53]; set xtics 0.1; set yrange [0.7:1.16]; set ytics 0.1; set xlabel "$c$" offset 0,0.7; set label 9 "$g_{km}$ at contact / BMCSL" at screen 0.022,graph 0.5 center rotate
set label 1 ink(Coarse, "1--1") at 0.475,1.125 right; set label 2 ink(Mixed, "1--2") at 0.44,1.03; set label 3 ink(Fine, "2--2") at 0.43,0.978
set label 4 ink(Guide, "Percus--Yevick") at 0.28,0.77; set label 5 "$\\times$ $Z-1$" at 0.32,1.03
array phi[3] = [0.3, 0.4, 0.5]
# the virial sum of the three contact values, by the shares of numbers of the scene
share = 0.084; l3 = 0.313**3; rest = 1 - share
a1(i) = 0.5*phi[i]/(share + rest*l3)
term(p) = p == 1 ? 8*share**2 : p == 2 ? 2*1.313**3*share*rest : 8*l3*rest**2
virial(i) = a1(i)*(term(1)*fluid("shaken.contact", 1, phi[i], v) + term(2)*fluid("shaken.contact", 2, phi[i], v) + term(3)*fluid("shaken.contact", 3, phi[i], v))
spread(i) = a1(i)*sqrt((term(1)*fluid("shaken.contact", 1, phi[i], e))**2 + (term(2)*fluid("shaken.contact", 2, phi[i], e))**2 + (term(3)*fluid("shaken.contact", 3, phi[i], e))**2)
lifts(i) = picked("bimodal-fluid", sprintf("shaken.Z@%g", phi[i]), v) - 1
array shift[3] = [-0.004, 0, 0.004]
py(p, i) = fluid("contact_py", p, phi[i], v)/b(p, i)
b(p, i) = fluid("contact_bmcsl", p, phi[i], v)
plot 1 with lines lt Guide lw 0.5, \
  for [p = 1:3] for [i = 1:3] "+" using (phi[i] + shift[p]):(fluid("shaken.contact", p, phi[i], v)/b(p, i)):(fluid("shaken.contact", p, phi[i], e)/b(p, i)) every ::0::0 with yerrorbars lt int(word(colour, p)) pt int(word(full, p)) ps 0.7, \
  for [p = 1:3] for [i = 1:2] "+" using (phi[i]):(py(p, i)):(0.1):(py(p, i + 1) - py(p, i)) every ::0::0 with vectors nohead lt int(word(colour, p)) dt 4 lw 1, \
  for [i = 1:3] "+" using (phi[i] - 0.012):(virial(i)/lifts(i)):(spread(i)/lifts(i)) every ::0::0 with yerrorbars lt Law pt 2 ps 0.7
unset label
# in packs, the bin of .01 at contact
set lmargin screen 0.58; set rmargin screen 0.985
set logscale xy; set xrange [0.115:1.2]; set xtics ("0.138" 0.138, "0.313" 0.313, "0.477" 0.477, "1" 1); set yrange [4:90]; set ytics (5, 10, 20, 50)
set xlabel "$\\lambda=a_2/a_1$" offset 0,0.7; set label 9 "first peak ($c=.6$, $\\xi=1/3$)" at screen 0.503,graph 0.5 center rotate
array l[4] = [0.138, 0.313, 0.477, 1]
of(q, p, i, c) = i == 1 ? picked("bimodal-138", sprintf("%s.%s", q, word(pairs, p)), c) : i == 2 ? picked("bimodal", sprintf("%s%s.%s@retry@60", q[1:8] eq "contact_" && q[9:9] ne "f" ? "" : "made.", q, word(pairs, p)), c) : i == 3 ? picked("bimodal-477", sprintf("%s.%s", q, word(pairs, p)), c) : \
  q eq "contact_first_bin" ? picked("first-peak", "made.contact_first_bin@retry@0.6", c) : q eq "contact_py" ? 1.3/0.16 : (1 - 0.3)/0.064
set label 1 ink(Coarse, "1--1") at 0.15,67; set label 2 ink(Mixed, "1--2") at 0.215,10.6; set label 3 ink(Fine, "2--2") at 0.6,5.2
set label 4 ink(Guide, "solid: BMCSL") at 1.15,55 right; set label 5 ink(Guide, "dashed: Percus--Yevick") at 1.15,43 right
rise(q, p, i) = of(q, p, i + 1, v) - of(q, p, i, v)
plot for [p = 1:3] for [i = 1:3] "+" using (l[i]):(of("contact_bmcsl", p, i, v)):(l[i + 1] - l[i]):(rise("contact_bmcsl", p, i)) every ::0::0 with vectors nohead lt int(word(colour, p)) lw 1, \
  for [p = 1:3] for [i = 1:3] "+" using (l[i]):(of("contact_py", p, i, v)):(l[i + 1] - l[i]):(rise("contact_py", p, i)) every ::0::0 with vectors nohead lt int(word(colour, p)) dt 4 lw 1, \
  for [p = 1:3] for [i = 1:4] "+" using (l[i]*(1 + 0.02*(p - 2))):(of("contact_first_bin", p, i, v)):(of("contact_first_bin", p, i, e)) every ::0::0 with yerrorbars lt int(word(colour, p)) pt int(word(full, p)) ps 0.7
unset multiplot
