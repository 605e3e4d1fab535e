# g of the centres of pentagons, freed of overlap by springs, and then shaken.
# data: turning
set xrange [1.75:6]; set yrange [0:5]
set xlabel "$R=r/a$"; set ylabel "$g(R)$" offset 1
set key at graph 0.98,0.95 right vertical
plot data("turning", "made.rdf.tsv") using "R":"g":"g_err" with yerrorlines lt Grown pt 6 ps 0.45 title "as made", \
  data("turning", "shaken.rdf.tsv") using "R":"g":"g_err" with yerrorlines lt Metropolis ps 0.45 title "shaken"
