# S Fig. 8: S_aa of shapes at .5, without overlap by aspect, exponent m and sides, with overlap by sides; and what sides change of the disc's.
# data: two-aspect two-exponent two-polygons two-grains two-ellipses
set terminal cairolatex pdf size 12.6cm,14cm font ",10" fontscale 0.9
set output out
curve(s, v) = data("two-".s, "S2@".v.".tsv")
both(s, v, d, w) = columns("by=R ".curve(s, v)." ".curve(d, w))
laws(v) = columns("by=R ".data("two-grains", "boolean@".v.".tsv")." ".data("two-ellipses", "boolean@1.tsv"))
less(name) = 1e3*(column(name) - column(name."_2"))
less_err(name) = 1e3*sqrt(column(name."_err")**2 + column(name."_err_2")**2)
aspects = "1 1.5 2 3 5"; exponents = "1 1.5 2 5 50"; polygons = "triangle square pentagon hexagon disc"
colour = "3 6 1 5 2"; sides = "2 1 6 5 3"
# a symbol and dashes for each colour
form(l) = int(word("7 5 9 0 11 13", l)); dash(l) = int(word("1 2 1 1 3 4", l))
set multiplot
unset key
set xrange [0:5]; set xtics 1
place = 'unset label; unset arrow; set lmargin screen 0.11 + 0.47*(p % 2); set rmargin screen 0.51 + 0.47*(p % 2); set tmargin screen 0.99 - 0.315*(p/2); set bmargin screen 0.725 - 0.315*(p/2); set label 8 word("a b c d e f", p + 1) at graph 0.035,graph 0.07'
word_of = 'do for [i = 1:words(list)] { set label 1 + i ink(int(word(inks, i)), word(list, i)) at graph 0.6,graph 1.02 - 0.09*i }'
set yrange [0.2:0.36]; set ytics 0.05; set mytics 2; set format y "%.2f"
do for [p = 0:3] {
  @place
  set arrow 1 from 0,0.25 to 5,0.25 nohead lt Guide lw 0.6 back
  if (p % 2 == 0) { set format y "%.2f" } else { set format y "" }
  if (p % 2 == 0) { set label 9 "$S_{aa}$" at screen 0.012,graph 0.5 center rotate }
  list = p == 0 ? aspects : p == 1 ? exponents : polygons; inks = p < 2 ? colour : sides
  @word_of
  if (p < 2) {
    set label 1 word("$a/b=$ $m=$", p + 1) at graph 0.57,graph 0.93 right
    plot for [i = 1:5] curve(word("aspect exponent", p + 1), word(list, i)) using "R":"S2":"S2_err" with yerrorlines lt int(word(colour, i)) lw 0.8 dt 0 + dash(int(word(colour, i))) pt form(int(word(colour, i))) ps 0.25
  }
  if (p == 2) {
    plot for [i = 1:4] curve("polygons", word("3 4 5 6", i)) using "R":"S2":"S2_err" with yerrorlines lt int(word(sides, i)) lw 0.8 dt 0 + dash(int(word(sides, i))) pt form(int(word(sides, i))) ps 0.25, \
      curve("exponent", "1") using "R":"S2":"S2_err" with yerrorlines lt 3 lw 0.8 pt form(3) ps 0.25
  }
  if (p == 3) {
    plot for [i = 1:4] data("two-grains", "boolean@".word("3 4 5 6", i).".tsv") using "R":"S2_phi" with lines lt int(word(sides, i)) lw 0.6, \
      data("two-ellipses", "boolean@1.tsv") using "R":"S2_phi" with lines lt 3 lw 0.6, \
      for [i = 1:4] curve("grains", word("3 4 5 6", i)) using "R":"S2":"S2_err" every 2::(i % 2) with yerrorbars lt int(word(sides, i)) lw 0.8 pt form(int(word(sides, i))) ps 0.3, \
      curve("ellipses", "1") using "R":"S2":"S2_err" every 2 with yerrorbars lt 3 lw 0.8 pt form(3) ps 0.3
  }
}
set yrange [-25:20]; set ytics 10; set format y "%.0f"
set xlabel "$R=r/a$" offset 0,0.4
do for [p = 4:5] {
  @place
  set arrow 1 from 0,0 to 5,0 nohead lt Guide lw 0.6 back
  if (p == 4) { set format y "$%g$" } else { set format y "" }
  if (p == 4) { set label 9 "$10^3\\times$ less the disc's" at screen 0.012,graph 0.5 center rotate }
  if (p == 4) {
    plot for [i = 1:4] both("polygons", word("3 4 5 6", i), "exponent", "1") using "R":(less("S2")):(less_err("S2")) with yerrorlines lt int(word(sides, i)) lw 0.8 dt 0 + dash(int(word(sides, i))) pt form(int(word(sides, i))) ps 0.25
  }
  if (p == 5) {
    plot for [i = 1:4] laws(word("3 4 5 6", i)) using "R":(less("S2_phi")) with lines lt int(word(sides, i)) lw 0.6, \
      for [i = 1:4] both("grains", word("3 4 5 6", i), "ellipses", "1") using "R":(less("S2")):(less_err("S2")) every 2::(i % 2) with yerrorbars lt int(word(sides, i)) lw 0.8 pt form(int(word(sides, i))) ps 0.3
  }
}
unset multiplot
