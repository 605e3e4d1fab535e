# The first peak against the number of shakes, by three rules, after growth at three rates, at B's three fractions.
# data: shake-marks
set terminal cairolatex pdf size 12.6cm,13cm font ",10" fontscale 0.9
set output out
table(rule, growth, phi) = data("shake-marks", "shaking@".rule."@".growth."@".phi.".tsv")
cs(phi) = equation("carnahan-starling", phi, "g(2+)")
zero = 0.4
shakes(least) = column("M") > least ? column("M") : NaN
mark(g) = int(word("8 5 7", g)); size_(g) = g == 1 ? 0.9 : 0.45
set logscale x
set xrange [0.25:1600]; unset mxtics
unset key
set multiplot layout 3,3 margins 0.095,0.985,0.095,0.955 spacing 0.025,0.03
do for [j = 1:3] {
  phi = word("0.575 0.6 0.63", j); f = real(phi); low = real(word("5 8 20", j)); high = real(word("18 26 56", j))
  set yrange [low:high]; set ytics real(word("2 4 10", j))
  do for [k = 1:3] {
    rule = word("metropolis retry collision", k)
    unset label; unset arrow
    if (j == 1) { set label ink(int(word("3 2 5", k)), word("Metropolis retry collision", k)) at graph 0.5,1.07 center }
    if (k == 1) { set label "first peak" at screen 0.018,graph 0.5 center rotate by 90; set format y "%g"
      set label sprintf("$\\phi=%s$", word(".575 .60 .63", j)) at graph 0.08,0.09 } else { set format y "" }
    if (j == 3) { set xtics ("0" zero, "1" 1, "10" 10, "100" 100, "1000" 1000); set xlabel "$M$, global shakes" offset 0,0.7 } else { set xtics ("" zero, "" 1, "" 10, "" 100, "" 1000); unset xlabel }
    if (j < 3) { set arrow from 0.25,cs(f) to 1600,cs(f) nohead lt Guide back }
    if (j == 2 && k == 3) { set label ink(Guide, "Carnahan--Starling") at graph 0.95,first cs(f)-1 right }
    if (j == 3 && k == 3) { set label "$\\vartriangle$ $a_0=10$" at graph 0.95,0.63 right; set label "$\\scriptstyle\\blacksquare$ $a_0=1$" at graph 0.95,0.54 right; set label "$\\bullet$ $a_0=.01$" at graph 0.95,0.45 right }
    of_rule = k == 1 ? Metropolis : k == 2 ? Retry : Collision
    b = (1 - real(word("0.43 0.21 0.04", j)))*known("shake-marks", "contact_first_bin_0@retry@1@".phi)
    if (k == 2) { set label "B" at 24.5,b - real(word("1.7 2.4 4.3", j)) center }
    plot for [g = 1:3] table(rule, word("10 1 0.01", g), phi) using (shakes(0)):"contact_first_bin":"contact_first_bin_err" with yerrorlines lt of_rule lw (g == 3 ? 1.2 : 0.8) dt 0 + (g == 2 ? 2 : 1) pt mark(g) ps size_(g), \
      for [g = 1:3] table(rule, word("10 1 0.01", g), phi) using (zero*1.25**(g - 2)):"contact_first_bin":"contact_first_bin_err" every ::0::0 with yerrorbars lt of_rule pt mark(g) ps size_(g), \
      for [n = 1:(k == 2 ? 2 : 0)] "+" using (n == 1 ? 10 : 60):(b) every ::0::0 with points lt Source pt (n == 1 ? 13 : 12) ps 1.1
  }
}
unset multiplot
