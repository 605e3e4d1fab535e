# The first peak of spheres whose radii scatter: its form, its height and place against the spread, and what a wrong radius makes of it.
# data: radius-read
set terminal cairolatex pdf size 12.6cm,13.2cm font ",10" fontscale 0.9
set output out
near(S) = columns("where=S=".S." ".data("radius-read", "near.tsv"))
wrong(S) = columns("where=S=".S." ".data("radius-read", "wrong.tsv"))
rows(q) = columns("'of=".q."@*' ".data("radius-read", "summary.tsv"))
height = known("radius-read", "h")
$B << END
error	change
5	-40
-5	7
END
spreads = "0 0.01 0.02 0.03 0.05 0.1"; names = "0 .01 .02 .03 .05 .1"; points = "6 9 5 7 13 11"; inks = "7 3 2 1 4 5"  # of spreads, which have no names
unset key
set multiplot
set lmargin screen 0.115; set rmargin screen 0.465; set tmargin screen 0.985; set bmargin screen 0.60
set xrange [1.85:2.35]; set xtics 0.1; set mxtics 2; set yrange [0:13.5]; set ytics 2; set mytics 2
set xlabel "$R$, with the right radius" offset 0,0.6; set label 10 "$g(R)$" at screen 0.018,graph 0.5 center rotate
set label 1 "spread" at 2.12,11.2
do for [i = 1:6] { set label 1 + i ink(int(word(inks, i)), word(names, i)) at 2.26,11.2 - 0.9*(i - 1) }
set arrow 1 from 2.06,0 to 2.06,13.5 nohead lt Guide back
set label 9 ink(Guide, "B, of Aste's: 2.06") at 2.07,12.9
set arrow 2 from 2,0 to 2,13.5 nohead lt Guide dt 3 back
plot near("0") using "r":(column("r") < 2 ? NaN : column("g")) with lines lt Law lw 1, \
  for [i = 2:6] near(word(spreads, i)) using "r":"smeared" with lines lt int(word(inks, i)) lw 1, \
  for [i = 2:6] near(word(spreads, i)) using "r":"g" every 3 with points lt int(word(inks, i)) pt int(word(points, i)) ps 0.35
unset label; unset arrow
set lmargin screen 0.60; set rmargin screen 0.985
set xrange [0.004:0.12]; set logscale xy; set xtics (".005" 0.005, ".01" 0.01, ".02" 0.02, ".05" 0.05, ".1" 0.1); unset mxtics
set yrange [2:30]; set ytics (2, 3, 5, 7, 10, 15, 20, 30); unset mytics
set xlabel "spread $s$" offset 0,0.6; set label 10 "height of the peak" at screen 0.525,graph 0.5 center rotate
set label 1 "$\\bullet$ measured" at graph 0.04,0.42
set label 2 ink(Guide, "equal, smeared") at graph 0.04,0.31
set label 3 ink(Law, "exponential, smeared") at graph 0.04,0.20
set label 4 ink(Guide, "$\\frac12+A/2\\sqrt\\pi s$") at graph 0.04,0.09
set arrow 1 from 0.004,height to 0.12,height nohead lt Guide dt 3
set label 5 ink(Guide, "equal, $g(2^+)$") at graph 0.97,first 1.13*height right
plot rows("limit") using "at":"value" with lines lt Guide lw 1.4, rows("model") using "at":"value" with lines lt Law dt 4, rows("smeared") using "at":"value" with lines lc rgb "#777777" lw 1.6, \
  rows("top") using "at":"value":"standard_error" with yerrorbars lt Law pt 7 ps 0.55
unset label; unset arrow; unset logscale y
set lmargin screen 0.115; set rmargin screen 0.465; set tmargin screen 0.485; set bmargin screen 0.085
set yrange [2:2.07]; set ytics 0.01; set label 10 "place of the peak, $R$" at screen 0.018,graph 0.5 center rotate; set format y "%.2f"
set arrow 1 from 0.004,2.06 to 0.12,2.06 nohead lt Guide
set label 1 ink(Guide, "B, of Aste's: 2.06") at 0.0045,2.0625
set label 2 ink(Guide, "$2+w$") at 0.0045,2.0495
plot rows("limit_R") using "at":"value" with lines lt Guide lw 1.4, rows("model_R") using "at":"value" with lines lt Law dt 4, rows("smeared_R") using "at":"value" with lines lc rgb "#777777" lw 1.6, \
  rows("top_R") using "at":"value":"standard_error" with yerrorbars lt Law pt 7 ps 0.55
unset label; unset arrow; unset logscale x; set format y "%g"
set lmargin screen 0.61; set rmargin screen 0.985
set xrange [-10:10]; set xtics 5; set mxtics 5; set yrange [-100:50]; set ytics 20; set mytics 2; set format y "$%g$"; set format x "$%g$"
set xlabel "error of the radius, per cent" offset 0,0.6; set label 10 "change of the peak, per cent" at screen 0.51,graph 0.5 center rotate
set arrow 1 from 0,-100 to 0,50 nohead lt Guide dt 3 back
set label 1 "spread" at 7.4,45 right
do for [i = 2:6] { set label 1 + i ink(int(word(inks, i)), word(names, i)) at 8.2,45 - 9*(i - 2) }
set label 9 "B" at 6.2,-38; set label 11 "B" at -5.2,18
plot 0 with lines lt Guide, for [i = 2:6] wrong(word(spreads, i)) using (100*column("error")):(100*column("first")) with lines lt int(word(inks, i)) lw 1.1 dt 0 + int(word("1 1 2 1 4 5", i)), \
  for [i = 3:6] wrong(word(spreads, i)) using (column("error") > 0.001 ? NaN : 100*column("error")):(100*column("read")) with lines lt int(word(inks, i)) lw 1.4 dt 3, \
  $B using "error":"change" with points lt Source pt 12 ps 1.2
unset multiplot
