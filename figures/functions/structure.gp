# The structure factor of a fluid of hard spheres and of dense packs, with Percus and Yevick's.
# data: structure-fluid structure-packs
set terminal cairolatex pdf size 12.6cm,10.5cm font ",10" fontscale 0.9
set output out
f(scene, stage) = data(scene, stage.".structure.tsv")
set multiplot
set lmargin screen 0.12; set rmargin screen 0.98
set xrange [0:15]; set label 1 "$S(k)$" at screen 0.018,graph 0.5 center rotate
set tmargin screen 0.985; set bmargin screen 0.58
set yrange [0:2.2]; set key at graph 0.98,0.95 right vertical
set label 2 "$\\phi=.3$" at graph 0.04,0.9
plot f("structure-fluid", "made") using "ka":"S":"S_err" every 2 with yerrorbars lt Added ps 0.4 title "added at random", \
  f("structure-fluid", "shaken") using "ka":"S":"S_err" every 2 with yerrorbars lt Dynamics ps 0.35 title "the fluid (by dynamics)", \
  f("structure-fluid", "shaken") using "ka":"S_py" with lines lt Py title "Percus--Yevick"
set tmargin screen 0.49; set bmargin screen 0.11
set xlabel "$ka$"; set logscale y; set format y "%g"; set yrange [0.005:400]; set label 2 "$\\phi=.575$" at graph 0.04,0.9
plot f("structure-packs", "made") using "ka":"S":"S_err" every 2 with yerrorbars lt Grown pt 6 ps 0.5 title "as grown", \
  f("structure-packs", "shaken") using "ka":"S":"S_err" every 2 with yerrorbars lt Dynamics ps 0.35 title "shaken (by dynamics)", \
  f("structure-packs", "shaken") using "ka":"S_py" with lines lt Py title "Percus--Yevick"
unset multiplot
