# Figs. 12 and 13 of B: g_12 and g_22 of more particles and of more shakes, the differences in standard errors, and what the errors and the first peaks depend on.
# data: bimodal bimodal-large
set terminal cairolatex pdf size 12.6cm,14cm font ",10" fontscale 0.9
set output out
few(pair, M) = data("bimodal", sprintf("shaken.partial.%s@retry@%d.tsv", pair, M))
many(pair, N) = data("bimodal-large", sprintf("shaken.partial.%s@%d.tsv", pair, N))
l = 0.313
# B's scale; a is the radius of the first
on(a) = (column("R") - a)/l + 1
bins(file) = columns("bin=5 ".file)
# ten bins together, of two files
pair_of(one, two) = columns("bin=10 ".one." ".two)
# the error of a bin of g_11, g_12, g_22 in packs of 1000 and 7000 particles, and of 2000: root of the mean square in a range
array noise[9]
do for [p = 1:3] { do for [i = 1:3] {
  pair = word("L-L L-S S-S", p); a = real(word("1 1 0.313", p)); from = real(word("5.8 3 3", p)); to = real(word("9.3 12 12", p))
  file = i == 3 ? few(pair, 3) : many(pair, i == 1 ? 1000 : 7000)
  stats file using (on(a) > from && on(a) < to ? column("g_err")**2 : NaN) nooutput
  noise[3*p - 3 + i] = sqrt(STATS_mean)
} }
v = "value"; e = "standard_error"
unset key
set multiplot
do for [j = 1:2] {
  pair = word("L-S S-S", j); a = real(word("1 0.313", j))
  set lmargin screen 0.10 + 0.50*(j - 1); set rmargin screen 0.485 + 0.50*(j - 1)
  set xrange [2:12]; set xtics 2; set mxtics 4
  set tmargin screen 0.985; set bmargin screen 0.70; set format x ""; unset xlabel
  set format y "$%g$"; set yrange [(j == 1 ? 0.7 : 0.86):(j == 1 ? 1.5 : 1.34)]; dy = j == 1 ? 0.2 : 0.1; set ytics dy
  unset label; unset arrow
  set label 9 sprintf("$g_{%s}$", word("12 22", j)) at screen 0.022 + 0.5*(j - 1),graph 0.5 center rotate
  set label 1 ink(Guide, "$N=7000$, $M=3$") at graph 0.4,0.93; set label 2 "$2000$, $3$" at graph 0.4,0.83; set label 3 "$2000$, $60$" at graph 0.4,0.73
  plot 1 with lines lt Guide lw 0.5, bins(many(pair, 7000)) using (on(a)):"g" with lines lc rgb "#aaaaaa" lw 3, bins(few(pair, 3)) using (on(a)):"g" with lines lc rgb "#000000" lw 0.7, bins(few(pair, 60)) using (on(a)):"g" with lines lc rgb "#000000" lw 1.4 dt 4
  unset label
  set tmargin screen 0.665; set bmargin screen 0.48; set format x "%g"
  set xlabel sprintf("$R_{%s}$", word("12 22", j)) offset 0,0.7; set yrange [-9.5:5.5]; set ytics 5; if (j == 1) { set label 9 "difference / error" at screen 0.022,graph 0.5 center rotate }
  set label 1 "$\\bullet$ $7000-2000$, both $M=3$" at graph 0.12,0.26; set label 2 ink(Guide, "$\\scriptstyle\\square$ $M=60$ less $M=3$, 2000") at graph 0.12,0.11
  plot -2 with lines lt Guide lw 0.5, 2 with lines lt Guide lw 0.5, \
    pair_of(few(pair, 60), few(pair, 3)) using (on(a)):(apart("g")) with points lc rgb "#777777" lw 1.2 pt 4 ps 0.4, \
    pair_of(many(pair, 7000), few(pair, 3)) using (on(a)):(apart("g")) with points lc rgb "#000000" pt 7 ps 0.3
}
unset label
# the law of errors
set tmargin screen 0.385; set bmargin screen 0.09; set lmargin screen 0.105; set rmargin screen 0.485
set logscale xy; set xrange [1.5e4:2.4e5]; set xtics (2e4, 5e4, 1e5, 2e5) ; unset mxtics; set format x "$%.0s{\\cdot}10^{%T}$"; set xtics add ("$2{\\cdot}10^4$" 2e4, "$5{\\cdot}10^4$" 5e4, "$10^5$" 1e5, "$2{\\cdot}10^5$" 2e5)
set yrange [0.0045:0.16]; set ytics (0.01, 0.02, 0.05, 0.1); set format y "%g"; set xlabel "$PN$" offset 0,0.7; set label 9 "error of a bin of $g_{km}$" at screen 0.018,graph 0.5 center rotate
s11 = noise[3]; s12 = noise[6]; s22 = noise[9]
set label 1 ink(Coarse, "1--1") at 1.7e4,1.45*s11*sqrt(16e4/23e3); set label 2 ink(Mixed, "1--2") at 1.7e4,1.4*s12*sqrt(16e4/23e3); set label 3 ink(Fine, "2--2") at 1.7e4,0.72*s22*sqrt(16e4/23e3)
set label 4 "$N=1000$" at 1.6e4,0.0063; set label 5 "7000, 2000" at 1.35e5,0.0063 center
array at[3] = [23e3, 157e3, 165e3]
plot s11*sqrt(16e4/x) with lines lt Coarse lw 0.7, s12*sqrt(16e4/x) with lines lt Mixed lw 0.7, s22*sqrt(16e4/x) with lines lt Fine lw 0.7, \
  for [i = 1:3] "+" using (at[i]):(noise[0 + i]) every ::0::0 with points lt Coarse pt (i < 3 ? 5 : 4) ps 0.6, \
  for [i = 1:3] "+" using (at[i]):(noise[3 + i]) every ::0::0 with points lt Mixed pt (i < 3 ? 9 : 8) ps 0.7, \
  for [i = 1:3] "+" using (at[i]):(noise[6 + i]) every ::0::0 with points lt Fine pt (i < 3 ? 7 : 6) ps 0.7
unset label; unset logscale
# the first peaks against M
set lmargin screen 0.62; set rmargin screen 0.985
set xrange [-3:76]; set xtics ("0" 0, "3" 20, "30" 40, "60" 60); set format xy "$%g$"; set xlabel "$M$" offset 0,0.7
set yrange [-36:9]; set ytics 10; set label 9 "change of first peak, \\%" at screen 0.528,graph 0.5 center rotate
c(rule, pair, M, k) = M == 0 ? 0 : 100*picked("bimodal", sprintf("change.contact_first_bin.%s@%s@%d", pair, rule, M), k)
array M[4] = [0, 3, 30, 60]
array at_[4] = [0, 20, 40, 60]
set label 1 ink(Coarse, "1--1") at 64,c("retry", "L-L", 60, v); set label 2 ink(Mixed, "1--2") at 64,c("retry", "L-S", 60, v) + 1.2; set label 3 ink(Fine, "2--2") at 64,c("retry", "S-S", 60, v) - 1.5
set label 4 "$\\Diamond$ B, $g_{11}$" at 24,-16.5; set label 5 "Metropolis: open" at 5,6.5
plot 0 with lines lt Guide lw 0.5, for [i = 1:4] for [p = 1:3] "+" using (at_[i] + 1.2*(p - 2)):(c("retry", word("L-L L-S S-S", p), M[i], v)):(c("retry", word("L-L L-S S-S", p), M[i], e)) every ::0::0 with yerrorbars lt int(word("2 3 1", p)) pt int(word("5 9 7", p)) ps 0.6, \
  for [i = 2:4] for [p = 1:3] "+" using (at_[i] + 1.2*(p - 2)):(c("metropolis", word("L-L L-S S-S", p), M[i], v)):(c("metropolis", word("L-L L-S S-S", p), M[i], e)) every ::0::0 with yerrorbars lt int(word("2 3 1", p)) pt int(word("4 8 6", p)) ps 0.6, \
  "+" using (60):(-25) every ::0::0 with points lt Source pt 12 ps 1.1, "+" using (40):(-25) every ::0::0 with points lt Source pt 12 ps 1.1, "+" using (20):(100*(1.12*0.75 - 1)) every ::0::0 with points lt Source pt 12 ps 1.1
unset multiplot
