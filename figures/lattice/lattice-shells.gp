# B Fig. 7: neighbours of a site of the simple cubic lattice, and what small boxes show.
# data: lattice-shells lattice-n1 lattice-n2
set xrange [1.5:10.2]; set yrange [0:57]
set xlabel "$R=r/a$"; set ylabel "$I(R)$, centres in the shell"
set arrow from 3,0 to 3,53 nohead lt Guide
set arrow from 5,0 to 5,53 nohead lt Guide
set label "$n_l=1$" at 3.1,52 left tc rgb "#777777"
set label "$n_l=2$" at 5.1,52 left tc rgb "#777777"
plot data("lattice-shells", "shells.tsv") using "R":"I" with impulses lt 1 lw 2.5 title "$n_l=5$", \
  "" using "R":(column("I") + (abs(column("R")**2 - 80) < 0.1 ? 4 : 0)):('\\footnotesize '.sprintf("%d", column("I"))) with labels offset 0,0.6 notitle, \
  data("lattice-n2", "shells.tsv") using "R":"I" with points lt 2 pt 6 ps 0.8 title "$n_l=2$", \
  data("lattice-n1", "shells.tsv") using "R":"I" with points lt 3 pt 8 ps 0.8 title "$n_l=1$"
