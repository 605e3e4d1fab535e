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
set label 2 ink(8, "fcc:") at 2.78,0.13 right
set label 3 ink(2, "$\\phi=.63$") at 3.33,1.72 right
set label 4 ink(1, "$.575$") at 3.52,1.12 left
do for [i = 1:4] { set label 10+i ink(8, word("$2\\sqrt2$ $2\\sqrt3$ $4$ $2\\sqrt5$", i)) at 2*sqrt(i+1),1.97 center }
plot data("lattice-fcc", "shells.tsv") using "R":"I" axes x1y2 with impulses lc rgb "#bbbbbb" lw 3, \
  "" using "R":"I":(sprintf("%d", column("I"))) axes x1y2 with labels offset 1.1,-0.5, \
  1 with lines lt 8, \
  g(0.575) using "R":"g" with lines lt 1, g(0.575) using "R":"g":"g_err" with yerrorbars lt 1 ps 0.25, \
  g(0.63) using "R":"g" with lines lt 2, g(0.63) using "R":"g":"g_err" with yerrorbars lt 2 ps 0.25
