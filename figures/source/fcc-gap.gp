# The shells of fcc over g of packs grown to .575 and .63: the second is where the packs have their gap.
# data: lattice-fcc first-peak
set terminal cairolatex pdf size 12.6cm,5.7cm font ",10"
set output out
g(c) = data("first-peak", sprintf("made.rdf@retry@%g.tsv", c))
unset key
set lmargin screen 0.085; set rmargin screen 0.985; set tmargin screen 0.98; set bmargin screen 0.21
set xrange [2.38:4.72]; set xlabel "$R=r/a$"; set xtics 0.5
set yrange [0:2.05]; set ytics 0.5
set y2range [0:49.2]
set label 1 "$g(R)$" at screen 0.022,graph 0.5 center rotate
set label 2 ink(Guide, "fcc:") at 2.78,0.13 right
set label 3 ink(Grown, "$\\phi=.63$ ($\\scriptstyle\\square$)") at 3.33,1.72 right
set label 4 ink(Grown, "$.575$ ($\\bullet$)") at 3.57,1.09 left
do for [i = 1:4] { set label 10+i ink(Guide, word("$2\\sqrt2$ $2\\sqrt3$ $4$ $2\\sqrt5$", i)) at 2*sqrt(i+1),1.97 center }
plot data("lattice-fcc", "shells.tsv") using "R":"I" axes x1y2 with impulses lc rgb "#bbbbbb" lw 3, \
  "" using "R":"I":(sprintf("%d", column("I"))) axes x1y2 with labels offset 1.1,-0.5, \
  1 with lines lt Guide, \
  g(0.575) using "R":"g" with lines lt Grown lw 1, g(0.575) using "R":"g":"g_err" with yerrorbars lt Grown ps 0.3, \
  g(0.63) using "R":"g" with lines lt Grown lw 1 dt 2, g(0.63) using "R":"g":"g_err" with yerrorbars lt Grown pt 4 ps 0.4
