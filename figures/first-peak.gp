# The change of the first peak under every rule, at B's three fractions, after growth and during it.
# data: first-peak first-peak-isothermal first-peak-longest first-peak-longest-isothermal first-peak-during first-peak-during-isothermal unimodal-peaks
set terminal cairolatex pdf size 12.6cm,14cm font ",10" fontscale 0.9
set output out
ink(n, s) = "\\textcolor[HTML]{".word("0072B2 D55E00 009E73 CC79A7 B57B00 3A94C8 000000 777777", n)."}{".s."}"
rules = "metropolis retry collision collision-longest chain newton dynamics"
head = "/^#/ {next} $1 == \"shake.rule\" {delete k; for (i = 1; i <= NF; i++) k[$i] = i; next}"
line(phi) = "BEGIN {n = split(\"".rules."\", r, \" \"); for (i = 1; i <= n; i++) y[r[i]] = n - i} $2 != ".phi." {next}"
x = "contact_first_bin"
# line of the rule, change in per cent and its error: after growth, of the same packs
after(s, phi) = "< awk -F'\\t' '".head.line(phi)." {print y[$1] \"\\t\" 100*$k[\"change.".x."\"] \"\\t\" 100*$k[\"change.".x."_err\"]}' ".data(s, "sweep.tsv")
# the same after ten shakes; and of the highest bin by B's rule after n = 1: 10, 2: 60, which at .63 is the bin at contact
ten(phi) = "< awk -F'\\t' '".head.line(phi)." {print y[$1] \"\\t\" 100*$k[\"change.".x."_10\"] \"\\t\" 100*$k[\"change.".x."_10_err\"]}' ".data("first-peak", "sweep.tsv")
top(n, phi) = phi eq "0.63" ? "< awk -F'\\t' '".head." $1 == \"retry\" && $2 == 0.63 {q = \"change.".x."\" (".n." == 1 ? \"_10\" : \"\"); print 5 \"\\t\" 100*$k[q] \"\\t\" 100*$k[q \"_err\"]}' ".data("first-peak", "sweep.tsv") : \
  "< awk -F'\\t' '".head." $1 == \"retry\" && $2 == ".word("10 60", n)." && $3 == ".phi." {print 5 \"\\t\" 100*$k[\"change.highest_g\"] \"\\t\" 100*$k[\"change.highest_g_err\"]}' ".data("unimodal-peaks", "sweep.tsv")
# the same during growth, against the packs of another scene that were not shaken
during(s, t, phi) = "< awk -F'\\t' '".head.line(phi)." {g = $k[\"made.".x."\"]; e = $k[\"made.".x."_err\"]/g} FNR == NR {h = g; f = e; next} {print y[$1] \"\\t\" 100*(g/h - 1) \"\\t\" 100*g/h*sqrt(e^2 + f^2)}' ".data(t, "sweep.tsv")." ".data(s, "sweep.tsv")
set xrange [-100:25]; set xtics 20; set mxtics 2; set yrange [-0.6:7.5]
set ytics ("Metropolis" 6, "retry (B)" 5, "collision" 4, "collision, longest" 3, "event chain" 2, "Newtonian chain" 1, "dynamics" 0) scale 0
unset key
set multiplot
do for [j = 1:3] {
  phi = word("0.575 0.6 0.63", j); b = real(word("-43 -21 -4", j))
  set lmargin screen 0.20; set rmargin screen 0.985; set tmargin screen 0.99 - 0.305*(j - 1); set bmargin screen 0.70 - 0.305*(j - 1)
  unset label; unset arrow; unset object
  if (j < 3) { set format x ""; unset xlabel } else { set format x "$%g$"; set xlabel "change of the first peak, per cent" offset 0,0.7 }
  set label sprintf("$\\phi=%s$", word(".575 .60 .63", j)) at graph 0.02,0.93
  do for [i = 0:5] { set arrow from -100,i + 0.5 to 25,i + 0.5 nohead lc rgb "#dddddd" lw 0.6 back }
  set arrow from 0,-0.6 to 0,6.6 nohead lt 8 back
  set arrow from b,-0.6 to b,6.6 nohead lt 7 dt 2 back
  set label sprintf("B: $%g$", b) at b,7 center
  if (j == 3) {
    set label ink(1, "$\\bullet$ after literal growth, small: $M=10$") at -98,4.8; set label ink(1, "$\\circ$ after isothermal growth") at -98,4
    set label ink(2, "$\\scriptstyle\\blacksquare$ during literal growth") at -98,3.2; set label ink(2, "$\\scriptstyle\\square$ during isothermal growth") at -98,2.4; set label ink(4, "$\\scriptstyle\\blacktriangle\\,\\vartriangle$ the highest bin, $M=60$, 10") at -98,1.6
  }
  plot after("first-peak", phi) using 2:($1 + 0.26):3 with xerrorbars lt 1 pt 7 ps 0.6, \
    ten(phi) using 2:($1 + 0.36):3 with xerrorbars lt 1 pt 7 ps 0.3, \
    for [n = 1:2] top(n, phi) using 2:($1 + 0.46 - 0.1*n):3 with xerrorbars lt 4 pt (7 + n) ps 0.65, \
    after("first-peak-longest", phi) using 2:($1 + 0.24):3 with xerrorbars lt 1 pt 7 ps 0.6, \
    after("first-peak-isothermal", phi) using 2:($1 + 0.08):3 with xerrorbars lt 1 pt 6 ps 0.6, \
    after("first-peak-longest-isothermal", phi) using 2:($1 + 0.08):3 with xerrorbars lt 1 pt 6 ps 0.6, \
    during("first-peak-during", "first-peak", phi) using 2:($1 - 0.08):3 with xerrorbars lt 2 pt 5 ps 0.55, \
    during("first-peak-during-isothermal", "first-peak-isothermal", phi) using 2:($1 - 0.24):3 with xerrorbars lt 2 pt 4 ps 0.55
}
unset multiplot
