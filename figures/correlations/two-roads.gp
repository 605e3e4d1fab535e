# S_aa of squares at .7 by two roads, before and after shaking, and what shaking changed.
# data: two-roads
set terminal cairolatex pdf size 12.6cm,6.4cm font ",10" fontscale 0.9
set output out
curve(stage, road) = data("two-roads", stage.".S2@".road.".tsv")
changed(road) = columns("by=R ".curve("shaken", road)." ".curve("made", road))
less(name) = 1e3*(column(name) - column(name."_2"))
less_err(name) = 1e3*sqrt(column(name."_err")**2 + column(name."_err_2")**2)
set multiplot
unset key
set tmargin screen 0.97; set bmargin screen 0.18
set xrange [0:6]; set xtics 1
set xlabel "$R=r/a$" offset 0,0.4
set lmargin screen 0.11; set rmargin screen 0.46
set yrange [0.46:0.52]; set ytics 0.02; set mytics 2; set format y "%.2f"
set arrow 1 from 0,0.49 to 6,0.49 nohead lt Guide lw 0.6 back
set label 9 "$S_{aa}$" at screen 0.012,graph 0.5 center rotate
set label 1 ink(Grown, "$\\bullet$ springs") at graph 0.96,graph 0.22 right
set label 2 ink(Added, "$\\scriptstyle\\blacklozenge$ areas") at graph 0.96,graph 0.14 right
set label 3 ink(Metropolis, "$\\scriptstyle\\blacktriangle$ both, shaken") at graph 0.96,graph 0.06 right
plot curve("made", "dynamics") using "R":"S2":"S2_err" with yerrorlines lt Grown lw 1 ps 0.25, curve("made", "area") using "R":"S2":"S2_err" with yerrorlines lt Added lw 1 ps 0.3, \
  for [i = 1:2] curve("shaken", word("dynamics area", i)) using "R":"S2":"S2_err" with yerrorlines lt Metropolis dt i lw 1 ps 0.25
unset label; unset arrow
set lmargin screen 0.6; set rmargin screen 0.985
set yrange [-6:6]; set ytics 2; set format y "$%g$"
set arrow 1 from 0,0 to 6,0 nohead lt Guide lw 0.6 back
set label 9 "$10^3\\times$ change by shaking" at screen 0.515,graph 0.5 center rotate
set label 1 ink(Grown, "$\\bullet$ springs") at graph 0.96,graph 0.93 right
set label 2 ink(Added, "$\\scriptstyle\\blacklozenge$ areas") at graph 0.96,graph 0.84 right
plot for [i = 1:2] changed(word("dynamics area", i)) using "R":(less("S2")):(less_err("S2")) with yerrorlines lt (i == 1 ? Grown : Added) lw 1 ps 0.3
unset multiplot
