# Figs. 10 and 11 of B: g_12 and g_22 at c = .6, lambda = .313, as grown and after 60 shakes, on their scales.
# data: bimodal
set terminal cairolatex pdf size 12.6cm,12.4cm font ",10" fontscale 0.9
set output out
table(stage, pair, rule) = data("bimodal", sprintf("%s.partial.%s@%s@60.tsv", stage, pair, rule))
l = 0.313
bins(file, n) = columns(sprintf("bin=%d ", n).file)
# B's scale; a is the radius of the first
on(a) = (column("R") - a)/l + 1
unset key
set style fill transparent solid 0.25 noborder
# the pair of a rhombus in the middle: small, mixed, large; chains
k = 1/l
array geo12[5] = [sqrt(3) - k + sqrt(k*k + 2*k) + 1, 3.99568, (sqrt(3) - 1)*k + sqrt(1 + 2*k) + 1, 4, 2*(1 + k)]
array geo22[5] = [2*sqrt(3), 4*sqrt((2 + k)*k)/(1 + k), 2*sqrt(1 + 2*k), 4, 2*(1 + k)]
array word_[5] = ["a", "b", "c", "", "e"]
set multiplot
do for [j = 1:2] {
  pair = word("L-S S-S", j); a = real(word("1 0.313", j)); y0 = j == 1 ? 0.5 : 0.75; y1 = j == 1 ? 1.65 : 1.5
  unset label; unset arrow
  set tmargin screen 0.985 - 0.5*(j - 1); set bmargin screen 0.6 - 0.5*(j - 1)
  # near contact
  set lmargin screen 0.09; set rmargin screen 0.325
  set xrange [2:2.5]; set xtics 0.2; set mxtics 2; set yrange [1:(j == 1 ? 11.9 : 7.9)]; set ytics 2
  set xlabel (j == 1 ? "$R_{12}=(r-a_1)/a_2+1$" : "$R_{22}=r/a_2$") offset 0,0.7; set label 9 sprintf("$g_{%s}$", word("12 22", j)) at screen 0.022,graph 0.5 center rotate
  set label 1 ink(Grown, "$\\circ$ as grown") at graph 0.27,0.92
  set label 2 ink(Metropolis, "$\\scriptstyle\\blacktriangle$ Metropolis") at graph 0.27,0.82
  set label 3 ink(Retry, "$\\scriptstyle\\blacksquare$ retry (B)") at graph 0.27,0.72
  set label 4 ink(Py, "Percus--Yevick") at graph 0.27,0.62
  plot bins(table("made", pair, "retry"), 2) using (on(a)):"py" with lines lt Py, \
    bins(table("made", pair, "retry"), 2) using (on(a)):"g":"g_err" with yerrorbars lt Grown pt 6 ps 0.8, \
    bins(table("shaken", pair, "metropolis"), 2) using (on(a)):"g":"g_err" with yerrorbars lt Metropolis pt 9 ps 0.4, \
    bins(table("shaken", pair, "retry"), 2) using (on(a)):"g":"g_err" with yerrorlines lt Retry pt 5 ps 0.3
  unset label
  # beyond
  set lmargin screen 0.44; set rmargin screen 0.985
  set xrange [2:12]; set xtics 2; set mxtics 4; set yrange [y0:y1]; set ytics 0.25; set label 9 sprintf("$g_{%s}$", word("12 22", j)) at screen 0.368,graph 0.5 center rotate
  dy = y1 - y0
  set arrow 1 from 3.3,y0 + 0.16*dy to 3.3,y0 + 0.9*dy nohead lt Source lw 0.8 dt 2 back; set label 1 "3.3" at 3.3,y0 + 0.95*dy center
  set arrow 2 from 4,y0 + 0.16*dy to 4,y0 + 0.9*dy nohead lt Source lw 0.8 dt 2 back; set label 2 "4" at 4.08,y0 + 0.95*dy center
  set arrow 3 from 8.3,y0 + 0.16*dy to 8.3,y0 + 0.9*dy nohead lt Source lw 0.8 dt 2 back; set label 3 "8.3" at 8.3,y0 + 0.95*dy center
  set arrow 4 from k,y0 to k,y0 + 0.13*dy nohead lt Guide dt 1 lw 1.6 back; set label 4 ink(Guide, "$1/\\lambda$") at k - 0.2,y0 + 0.1*dy right
  do for [i = 1:5] {
    at = j == 1 ? geo12[i] : geo22[i]
    set arrow 10 + i from at,y0 to at,y0 + 0.08*dy nohead lt Guide dt 1 lw 1.6 back
    if (i < 3) { set label 10 + i ink(Guide, word_[i]) at at + (i == 1 ? 0.04 : -0.03),y0 + (i == 2 ? 0.165 : 0.115)*dy right } else { set label 10 + i ink(Guide, word_[i]) at at,y0 + 0.115*dy center }
  }
  set label 14 ink(Guide, "d") at 4.06,y0 + 0.115*dy
  plot 1 with lines lt Guide lw 0.5, bins(table("made", pair, "retry"), 4) using (on(a)):"py" with lines lt Py, \
    bins(table("made", pair, "retry"), 4) using (on(a)):(low("g")):(high("g")) with filledcurves lt Grown, bins(table("made", pair, "retry"), 4) using (on(a)):"g" with lines lt Grown lw 1, \
    bins(table("shaken", pair, "metropolis"), 4) using (on(a)):"g" with lines lt Metropolis lw 0.8, \
    bins(table("shaken", pair, "retry"), 4) using (on(a)):(low("g")):(high("g")) with filledcurves lt Retry, bins(table("shaken", pair, "retry"), 4) using (on(a)):"g" with lines lt Retry lw 1
}
unset multiplot
