# g(R) by gravity beside that of growth at about the same fraction, and diluted beside added.
# data: gravity side-grown side-diluted side-added
set terminal cairolatex pdf size 12.6cm,10.4cm font ",10" fontscale 0.9
set output out
phi = sprintf("%.3f", known("gravity", "fraction"))
set multiplot
unset key
set lmargin screen 0.09; set rmargin screen 0.985
set xrange [2:6]; set xtics 0.5; set yrange [0.3:2.2]; set ytics 0.5; set label 9 "$g(R)$" at screen 0.022,graph 0.5 center rotate
set arrow 1 from 2,1 to 6,1 nohead lt Guide back
set arrow 2 from 3.4641,0.3 to 3.4641,2.2 nohead lt Guide back
set tmargin screen 0.985; set bmargin screen 0.55; set format x ""; unset xlabel
set label 1 "$2\\sqrt3$" at 3.49,0.42
set label 2 ink(Gravity, "by gravity, $\\phi=".phi."$") at 4.5,1.9; set label 3 ink(Grown, "by growth, $\\phi=0.59$") at 4.5,1.72
plot data("side-grown", "made.rdf@0.59.tsv") using "R":"g" with lines lt Grown lw 1.2, \
  data("side-grown", "made.rdf@0.59.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Grown lw 0.8 ps 0.25, \
  data("gravity", "rdf.tsv") using "R":"g" with lines lt Gravity lw 1.2, \
  data("gravity", "rdf.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Gravity lw 0.8 ps 0.3
set tmargin screen 0.53; set bmargin screen 0.125; set format x "%g"; set xlabel "$R=r/a$" offset 0,0.3
set yrange [0.3:2.2]; unset label; set arrow 2 from 3.4641,0.3 to 3.4641,1.25 nohead lt Guide back
set label 9 "$g(R)$" at screen 0.022,graph 0.5 center rotate
set label 1 "$\\phi=.38$" at 5.4,1.9
set label 2 ink(Gravity, "diluted, moves between surfaces ($\\scriptstyle\\blacktriangle$)") at 2.75,1.9; set label 3 ink(Gravity, "diluted, moves between centres ($\\triangle$)") at 2.75,1.72
set label 6 ink(Gravity, "surfaces") at 4.62,1.55
set label 4 ink(Added, "by addition") at 2.75,1.54; set label 5 ink(Grown, "by growth") at 2.75,1.36
plot data("side-added", "rdf.tsv") using "R":"g" with lines lt Added lw 1.2, \
  data("side-added", "rdf.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Added lw 0.8 ps 0.25, \
  data("side-grown", "made.rdf@0.38.tsv") using "R":"g" with lines lt Grown lw 1.2, \
  data("side-grown", "made.rdf@0.38.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Grown lw 0.8 ps 0.25, \
  data("side-diluted", "rdf@surfaces.tsv") using "R":"g" with lines lt Gravity lw 1.2, \
  data("side-diluted", "rdf@surfaces.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Gravity lw 0.8 ps 0.3, \
  data("side-diluted", "rdf@centres.tsv") using "R":"g" with lines lt Gravity dt 2 lw 1.2, \
  data("side-diluted", "rdf@centres.tsv") using "R":"g":"g_err" every 3 with yerrorbars lt Gravity lw 0.8 pt 8 ps 0.35
unset multiplot
