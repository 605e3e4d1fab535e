# Figs. 1 and 2 of B: g(R) at .575 as grown, after shakes by B's rule and by Metropolis', and the change beyond the first shell.
# data: unimodal-peaks theory-curves
set terminal cairolatex pdf size 12.6cm,9.6cm font ",10" fontscale 0.9
set output out
made = data("unimodal-peaks", "made.rdf@retry@60@0.575.tsv")
shaken(rule, M) = data("unimodal-peaks", sprintf("shaken.rdf@%s@%d@0.575.tsv", rule, M))
theory = data("theory-curves", "theory.tsv")
# per cent by which g is changed, of five bins taken together; errors of the differences of the same packs
change(rule) = columns("bin=5 'where=R>2.5;R<4.5' ".shaken(rule, 60))
percent(v) = 100*column(v)/(column("g") - column("change"))
unset key
set style fill transparent solid 0.25 noborder
set multiplot
set bmargin screen 0.125; set tmargin screen 0.985; set lmargin screen 0.085; set rmargin screen 0.44
set xrange [2:2.2]; set xtics 0.05; set yrange [0:15.5]; set ytics 2
set xlabel "$R=r/a$" offset 0,0.7; set label 9 "$g(R)$" at screen 0.022,graph 0.5 center rotate
first = known("unimodal-peaks", "made.contact_first_bin@retry@60@0.575")
highest(M) = known("unimodal-peaks", sprintf("shaken.highest_R@retry@%d@0.575", M))
set label 1 ink(Grown, "$\\circ$ as grown (CRM)") at graph 0.28,0.93
set label 2 ink(Metropolis, "$\\scriptstyle\\blacktriangle$ Metropolis, $M=60$") at graph 0.28,0.87
set label 3 ink(Retry, "$\\scriptstyle\\blacksquare$ retry, $M=60$; $+$: 10") at graph 0.28,0.81
set label 4 ink(Py, "Percus--Yevick") at graph 0.28,0.75
set label 5 ink(Willis, "Willis") at graph 0.28,0.69
set label 6 "$\\Diamond$ B: $-43$\\%" at graph 0.28,0.63
plot theory using "R":"willis_0.575" with lines lt Willis, theory using "R":"py_0.575" with lines lt Py, \
  shaken("retry", 10) using "R":"g" with linespoints lt Retry lw 0.7 pt 1 ps 0.5, \
  made using "R":"g":"g_err" with yerrorlines lt Grown pt 6 ps 0.95, \
  shaken("metropolis", 60) using "R":"g":"g_err" with yerrorlines lt Metropolis ps 0.45, \
  shaken("retry", 60) using "R":"g":"g_err" with yerrorlines lt Retry ps 0.35, \
  for [R in sprintf("2.005 %g", highest(60))] "+" using (real(R)):(0.57*first) every ::0::0 with points lt Source pt 12 ps 1.1
unset label
set lmargin screen 0.55; set rmargin screen 0.985; set bmargin screen 0.40
set label 9 "$g(R)$" at screen 0.49,graph 0.5 center rotate; set xrange [2.5:4.5]; set xtics 0.5; set format x ""; unset xlabel; set yrange [0:1.9]; set ytics 0.5
h = 2*sqrt(3)
set object 1 rectangle from 2.75,graph 0 to 2.85,graph 0.86 fc rgb "#dddddd" fs solid 1 noborder behind
set arrow 1 from h,graph 0 to h,graph 0.86 nohead lt Guide back
set arrow 2 from 4,graph 0 to 4,graph 0.86 nohead lt Guide back
set label 1 ink(Guide, "$2\\sqrt3$") at h,graph 0.91 center
set label 2 ink(Guide, "$4$") at 4,graph 0.91 center
set label 3 ink(Guide, "B: gap") at 2.8,graph 0.91 center
plot theory using "R":"willis_0.575" with lines lt Willis, theory using "R":"py_0.575" with lines lt Py, \
  made using "R":(low("g")):(high("g")) with filledcurves lt Grown, made using "R":"g" with lines lt Grown lw 1, \
  shaken("metropolis", 60) using "R":(low("g")):(high("g")) with filledcurves lt Metropolis, shaken("metropolis", 60) using "R":"g" with lines lt Metropolis lw 1, \
  shaken("retry", 60) using "R":(low("g")):(high("g")) with filledcurves lt Retry, shaken("retry", 60) using "R":"g" with lines lt Retry lw 1
unset label
set tmargin screen 0.36; set bmargin screen 0.125
set format x "%g"; set xlabel "$R=r/a$" offset 0,0.7; set label 9 "change, \\%" at screen 0.478,graph 0.5 center rotate; set yrange [-6:6]; set ytics 5
set object 1 rectangle from 2.75,graph 0 to 2.85,graph 1
set arrow 1 from h,graph 0 to h,graph 1 nohead lt Guide back
set arrow 2 from 4,graph 0 to 4,graph 1 nohead lt Guide back
plot 0 with lines lt Guide, change("metropolis") using (column("R") - 0.006):(percent("change")):(percent("change_err")) with yerrorbars lt Metropolis ps 0.45, \
  change("retry") using (column("R") + 0.006):(percent("change")):(percent("change_err")) with yerrorbars lt Retry ps 0.35
unset multiplot
