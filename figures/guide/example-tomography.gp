# The example of a tomograph: g(R) and K(R) of the cube that was cut out, and of the whole pack.
# data: tomography-example beads-example
set terminal cairolatex pdf size 12.6cm,5.9cm font ",10" fontscale 0.9
set output out
unset key
set multiplot
set lmargin screen 0.1; set rmargin screen 0.48; set tmargin screen 0.97; set bmargin screen 0.19
set xrange [1.8:5.05]; set xtics 1; set mxtics 2; set yrange [0:10]; set ytics 2; set mytics 2
set xlabel "$R=r/a$" offset 0,0.4; set ylabel "$g(R)$" offset 1.2
set label 1 ink(8, "line: the whole pack") at 2.5,8.6
set label 2 ink(1, "points: the cube") at 2.5,7.5
plot data("beads-example", "rdf.tsv") using "R":"g" with lines lt 8 lw 1.2 dt 1, data("tomography-example", "rdf.tsv") using "R":"g" with points lt 1 pt 7 ps 0.4
unset label
set lmargin screen 0.63; set rmargin screen 0.985
set xrange [1.8:5.05]; set yrange [-4:4]; set ytics 2; set mytics 2
both = columns("by=R ".data("tomography-example", "K.tsv")." ".data("beads-example", "K.tsv"))
set xlabel "$R=r/a$" offset 0,0.4; set ylabel "difference of $K$, \\%" offset 0.6
plot 0 with lines lt 8, both using "R":(100*column("K")/column("K_2") - 100) with linespoints lt 1 pt 7 ps 0.4
unset multiplot
