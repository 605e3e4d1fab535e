# Figs. 5 and 6 of B: g(R) at .5925 in large packs as grown, and in packs of 2000 before and after their shakes.
# data: tomography tomography-shaken
set terminal cairolatex pdf size 12.6cm,12cm font ",10" fontscale 0.9
set output out
large = data("tomography", "rdf.tsv")
made = data("tomography-shaken", "made.rdf.tsv"); shaken = data("tomography-shaken", "shaken.rdf.tsv")
# n bins together, and over those of the large packs
less(file, from, to, n) = columns(sprintf("bin=%d 'where=R>%g;R<%g' %s %s", n, from, to, file, large))
unset key
set multiplot
set lmargin screen 0.105; set rmargin screen 0.49; set tmargin screen 0.985; set bmargin screen 0.66
set xrange [2:2.3]; set xtics 0.1; set mxtics 2; set yrange [0:21.5]; set ytics 5; set mytics 5
set format x ""; set label 9 "$g(R)$" at screen 0.02,graph 0.5 center rotate
set label 1 ink(Grown, "$N=35\\,000$, as grown") at graph 0.30,0.90
set label 2 ink(Grown, "$\\circ$ $N=2000$, as grown") at graph 0.30,0.79
set label 3 ink(Retry, "$\\scriptstyle\\blacksquare$ $N=2000$, shaken") at graph 0.30,0.68
plot large using "R":"g" with lines lt Grown, made using "R":"g":"g_err" every 2 with yerrorbars lt Grown pt 6 ps 0.55, \
  shaken using "R":"g":"g_err" with yerrorbars lt Retry ps 0.35
unset label
set lmargin screen 0.60; set rmargin screen 0.985; set label 9 "$g(R)$" at screen 0.53,graph 0.5 center rotate
set xrange [2.3:5]; set xtics 2.5,0.5; set mxtics 5; set yrange [0.3:1.7]; set ytics 0.5
plot large using "R":"g" with lines lt Grown, made using "R":"g" every 4 with points lt Grown pt 6 ps 0.45, \
  shaken using "R":"g" every 4::2 with points lt Retry ps 0.3
set tmargin screen 0.635; set bmargin screen 0.44
set format x "%g"; set format y "$%g$"; set yrange [-5:5]; set ytics 4; set mytics 2; set label 9 "difference, \\%"; set xlabel "$R=r/a$" offset 0,0.7
plot 0 with lines lt Guide, less(made, 2.3, 5, 10) using (column("R") - 0.012):(rise("g")):(rise_err("g")) with yerrorbars lt Grown pt 6 ps 0.45, \
  less(shaken, 2.3, 5, 10) using (column("R") + 0.012):(rise("g")):(rise_err("g")) with yerrorbars lt Retry ps 0.35
set lmargin screen 0.105; set rmargin screen 0.49
set format y "$%g$"; set xrange [2:2.3]; set xtics 0.1; set mxtics 2; set yrange [-30:30]; set ytics 20; set mytics 2; set label 9 "difference, \\%" at screen 0.015,graph 0.5 center rotate
plot 0 with lines lt Guide, less(made, 2, 2.3, 1) using (column("R") - 0.001):(rise("g")):(rise_err("g")) with yerrorbars lt Grown pt 6 ps 0.45, \
  less(shaken, 2, 2.3, 1) using (column("R") + 0.001):(rise("g")):(rise_err("g")) with yerrorbars lt Retry ps 0.35
set lmargin screen 0.105; set rmargin screen 0.985; set tmargin screen 0.345; set bmargin screen 0.10
set format y "%g"; set xrange [4:10]; set xtics 1; set mxtics 5; set yrange [0.8:1.25]; set ytics 0.1; set mytics 2; set label 9 "$g(R)$" at screen 0.02,graph 0.5 center rotate
plot 1 with lines lt Guide, large using "R":"g" with lines lt Grown, shaken using "R":"g":"g_err" every 6 with yerrorbars lt Retry ps 0.3
unset multiplot
