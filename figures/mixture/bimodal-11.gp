# Figs. 8 and 9 of B: g_11 at c = .6, lambda = .313, as grown and after 60 shakes, and the change beyond contact.
# data: bimodal
set terminal cairolatex pdf size 12.6cm,10.6cm font ",10" fontscale 0.9
set output out
made = data("bimodal", "made.partial.L-L@retry@60.tsv")
shaken(rule) = data("bimodal", sprintf("shaken.partial.L-L@%s@60.tsv", rule))
l = 0.313
bins(file, n) = columns(sprintf("bin=%d ", n).file)
change(rule) = columns("bin=10 'where=R>2.1' ".shaken(rule)." ".made)
first = known("bimodal", "made.contact_first_bin.L-L@retry@60")
unset key
set style fill transparent solid 0.25 noborder
set multiplot
# near contact
set lmargin screen 0.09; set rmargin screen 0.34; set bmargin screen 0.11; set tmargin screen 0.985
set xrange [2:2.2]; set xtics 0.1; set mxtics 2; set yrange [0:39]; set ytics 5
set xlabel "$R_{11}=r/a_1$" offset 0,0.7; set label 9 "$g_{11}$" at screen 0.022,graph 0.5 center rotate
set label 1 ink(Grown, "$\\circ$ as grown") at graph 0.28,0.93
set label 2 ink(Metropolis, "$\\scriptstyle\\blacktriangle$ Metropolis") at graph 0.28,0.88
set label 3 ink(Retry, "$\\scriptstyle\\blacksquare$ retry (B)") at graph 0.28,0.83
set label 4 ink(Py, "Percus--Yevick") at graph 0.28,0.78
set label 5 "$\\Diamond$ B: $-25$\\%" at graph 0.28,0.73
plot made using "R":"py" with lines lt Py, \
  made using "R":"g":"g_err" with yerrorlines lt Grown pt 6 ps 0.95, \
  shaken("metropolis") using "R":"g":"g_err" with yerrorlines lt Metropolis pt 9 ps 0.45, \
  shaken("retry") using "R":"g":"g_err" with yerrorlines lt Retry pt 5 ps 0.35, \
  "+" using (2.005):(0.75*first) every ::0::0 with points lt Source pt 12 ps 1.1
unset label
# beyond
set lmargin screen 0.44; set rmargin screen 0.985; set bmargin screen 0.36; set tmargin screen 0.985
set xrange [2:5.4]; set xtics 0.5; set mxtics 5; set format x ""; unset xlabel; set yrange [-0.2:1.98]; set ytics 0.5; set label 9 "$g_{11}$" at screen 0.366,graph 0.5 center rotate
array at[6] = [2.3, 2.64, 2.87, 3.464, 4, 4.54]
array word_[6] = ["2.3", "2.64", "2.87", "3.464", "4.0", "4.54"]
do for [i = 1:6] {
  set arrow i from at[i],graph 0.13 to at[i],graph (i == 2 ? 0.86 : 0.93) nohead lt Source lw 0.8 dt 2 back
  set label i + 1 word_[i] at at[i],1.92 - (i == 2 ? 0.14 : 0) center
}
# what configurations have: the middle pair of a rhombus small, mixed, large; chains 1-2-1 and 1-1-1
array geo[5] = [2*sqrt(1 + 2*l), 4*sqrt((2 + l)*l)/(1 + l), 2 + 2*l, 2*sqrt(3), 4]
do for [i = 1:5] { set arrow 10 + i from geo[i],-0.2 to geo[i],0.16 nohead lt Guide dt 1 lw 1.6 back }
set label 20 ink(Guide, "a\\,b\\,c") at 2.68,-0.1
set label 21 ink(Guide, "d") at geo[4] + 0.05,-0.1
set label 22 ink(Guide, "e") at geo[5] + 0.05,-0.1
set label 23 ink(Py, "Percus--Yevick") at 4.2,0.68
plot 0 with lines lt Guide lw 0.5, bins(made, 2) using "R":"py" with lines lt Py, \
  bins(made, 2) using "R":(low("g")):(high("g")) with filledcurves lt Grown, bins(made, 2) using "R":"g" with lines lt Grown lw 1, \
  bins(shaken("metropolis"), 2) using "R":(low("g")):(high("g")) with filledcurves lt Metropolis, bins(shaken("metropolis"), 2) using "R":"g" with lines lt Metropolis lw 1, \
  bins(shaken("retry"), 2) using "R":(low("g")):(high("g")) with filledcurves lt Retry, bins(shaken("retry"), 2) using "R":"g" with lines lt Retry lw 1
unset label; unset arrow
set tmargin screen 0.33; set bmargin screen 0.11
set format x "%g"; set xlabel "$R_{11}=r/a_1$" offset 0,0.7; set label 9 "change, \\%" at screen 0.366,graph 0.5 center rotate; set yrange [-9:9]; set ytics 5
plot 0 with lines lt Guide, change("metropolis") using (column("R") - 0.012):(rise("g")):(rise_err("g")) with yerrorbars lt Metropolis pt 9 ps 0.45, \
  change("retry") using (column("R") + 0.012):(rise("g")):(rise_err("g")) with yerrorbars lt Retry pt 5 ps 0.35
unset multiplot
