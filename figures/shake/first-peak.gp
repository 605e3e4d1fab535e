# The change of the first peak under every rule, at B's three fractions, after growth and during it.
# data: first-peak first-peak-isothermal first-peak-longest first-peak-longest-isothermal first-peak-during first-peak-during-isothermal unimodal-peaks
set terminal cairolatex pdf size 12.6cm,14cm font ",10" fontscale 0.9
set output out
rules = "dynamics newton chain collision-longest collision retry metropolis"; inks = "12 6 4 13 5 2 3"
# each rule has its colour, and a symbol says what was done
line(r) = sum [i = 1:words(rules)] (word(rules, i) eq r ? i - 1 : 0)
at(shift) = line(stringcolumn("shake.rule")) + shift
rule(x) = int(word(inks, line(stringcolumn("shake.rule")) + 1))
per(name) = 100*column(name)
change = "change.contact_first_bin"; ten = change."_10"; grown = "made.contact_first_bin"
# after growth, of the same packs
after(s, phi) = columns("where=fraction=".phi." ".data(s, "sweep.tsv"))
# the highest bin by B's rule after 10 and 60 shakes; at .63 it is the bin at contact
top(n, phi) = phi eq "0.63" ? columns("'where=shake.rule=retry;fraction=0.63' ".data("first-peak", "sweep.tsv")) : \
  columns("'where=shake.rule=retry;shake.sweeps=".word("10 60", n).";fraction=".phi."' ".data("unimodal-peaks", "sweep.tsv"))
tall(n, phi) = phi ne "0.63" ? "change.highest_g" : n == 1 ? ten : change
# during growth, against the packs of another scene that were not shaken
during(s, t, phi) = columns("'by=shake.rule' where=fraction=".phi." ".data(s, "sweep.tsv")." ".data(t, "sweep.tsv"))
set xrange [-100:25]; set xtics 20; set mxtics 2; set yrange [-0.6:7.5]
set ytics ("Metropolis" 6, "retry (B)" 5, "collision" 4, "collision, longest" 3, "event chain" 2, "Newtonian chain" 1, "dynamics" 0) scale 0
unset key
set multiplot
do for [j = 1:3] {
  phi = word("0.575 0.6 0.63", j); b = real(word("-43 -21 -4", j))
  set lmargin screen 0.235; set rmargin screen 0.985; set tmargin screen 0.99 - 0.305*(j - 1); set bmargin screen 0.70 - 0.305*(j - 1)
  unset label; unset arrow; unset object
  if (j < 3) { set format x ""; unset xlabel } else { set format x "$%g$"; set xlabel "change of the first peak, per cent" offset 0,0.7 }
  set label sprintf("$\\phi=%s$", word(".575 .60 .63", j)) at graph 0.02,0.93
  do for [i = 0:5] { set arrow from -100,i + 0.5 to 25,i + 0.5 nohead lc rgb "#dddddd" lw 0.6 back }
  set arrow from 0,-0.6 to 0,6.6 nohead lt Guide back
  set arrow from b,-0.6 to b,6.6 nohead lt Source dt 2 back
  set label sprintf("B: $%g$", b) at b,7 center
  if (j == 3) {
    set label ("$\\bullet$ after literal growth, small: $M=10$") at -98,5; set label ("$\\circ$ after isothermal growth") at -98,4
    set label ("$\\scriptstyle\\blacksquare$ during literal growth") at -98,3; set label ("$\\scriptstyle\\square$ during isothermal growth") at -98,2; set label ("$\\scriptstyle\\blacktriangle\\,\\vartriangle$ the highest bin, $M=60$, 10") at -98,1
  }
  plot for [s in "first-peak first-peak-longest"] after(s, phi) using (per(change)):(at(0.26)):(per(change."_err")):(rule(0)) with xerrorbars lc variable lw 1.6 pt 7 ps 0.6, \
    after("first-peak", phi) using (per(ten)):(at(0.36)):(per(ten."_err")):(rule(0)) with xerrorbars lc variable lw 1.6 pt 7 ps 0.3, \
    for [n = 1:2] top(n, phi) using (per(tall(n, phi))):(at(0.46 - 0.1*n)):(per(tall(n, phi)."_err")) with xerrorbars lt Retry pt (n == 1 ? 8 : 9) ps 0.65, \
    for [s in "first-peak-isothermal first-peak-longest-isothermal"] after(s, phi) using (per(change)):(at(0.08)):(per(change."_err")):(rule(0)) with xerrorbars lc variable lw 1.6 pt 6 ps 0.6, \
    during("first-peak-during", "first-peak", phi) using (rise(grown)):(at(-0.08)):(rise_err(grown)):(rule(0)) with xerrorbars lc variable lw 1.6 pt 5 ps 0.55, \
    during("first-peak-during-isothermal", "first-peak-isothermal", phi) using (rise(grown)):(at(-0.24)):(rise_err(grown)):(rule(0)) with xerrorbars lc variable lw 1.6 pt 4 ps 0.55
}
unset multiplot
