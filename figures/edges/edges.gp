# Bias and scatter of K, g and the contact value of cubes cut out of larger packs, against their number of particles, by the treatment of edges.
# data: edges-read
set terminal cairolatex pdf size 12.6cm,13.4cm font ",10" fontscale 0.9
set output out
rows(packs, edges) = columns("'where=packs=".packs.";edges=".edges."' ".data("edges-read", "edges.tsv"))
ways = "minus ripley translation"; inks = "3 2 1"; forms = "4 5 7"; aside = "0.94 1 1.06"
side(panel) = panel ? 0.525 : 0.02
unset key; set logscale x; set xrange [110:2900]; set xtics (150, 300, 600, 1200, 2400); unset mxtics
set multiplot
do for [panel = 0:1] {
  packs = panel ? "beads" : "points"
  if (panel) { set lmargin screen 0.60; set rmargin screen 0.985 } else { set lmargin screen 0.105; set rmargin screen 0.49 }
  set tmargin screen 0.985; set bmargin screen 0.70; set format x ""; unset logscale y; unset xlabel
  if (panel) { set yrange [-1:2]; set ytics 1; set mytics 2 } else { set yrange [-5:2]; set ytics 1; set mytics 2 }
  set label 1 "bias of $K(3)$, per cent" at screen side(panel),graph 0.5 center rotate
  set label 2 (panel ? "beads, $\\phi=.5925$" : "independent points") at graph 0.97,0.94 right
  if (panel) { set label 3 ink(Law, "$1/N$") at 370,0.62 } else { do for [i = 1:3] { set label 3 + i ink(int(word(inks, i)), word("minus Ripley's translation", i)) at graph 0.97,(0.45 - 0.13*i) right } }
  plot 0 with lines lt Guide lw 0.6, for [i = 1:3] rows(packs, word(ways, i)) using (column("N")*real(word(aside, i))):(100*column("K")):(100*column("K_err")) with yerrorbars lt int(word(inks, i)) lw 1 pt int(word(forms, i)) ps 0.5, \
    rows(packs, "ripley") using "N":(panel ? 100*column("one") : 0) with lines lt Law dt 3 lw 1
  do for [i = 2:6] { unset label i }
  set tmargin screen 0.67; set bmargin screen 0.385; set logscale y; unset mytics
  set yrange [0.2:20]; set ytics (0.3, 1, 3, 10)
  set label 1 "scatter of $K(3)$, per cent" at screen side(panel),graph 0.5 center rotate
  plot for [i = 1:3] rows(packs, word(ways, i)) using "N":(100*column("K_sd")):(100*column("K_sd_err")) with yerrorlines lt int(word(inks, i)) lw 1 pt int(word(forms, i)) ps 0.5
  set tmargin screen 0.355; set bmargin screen 0.095; set format x "%g"; set xlabel "particles in the window, $N$" offset 0,0.6
  set yrange [1:60]; set ytics (1, 3, 10, 30)
  set label 1 "scatter of $g$, per cent" at screen side(panel),graph 0.5 center rotate
  set label 3 "lines: $2.8\\le R<3$" at graph 0.05,0.22
  if (panel) {
    set label 4 "dotted: contact value" at graph 0.05,0.10
    plot for [i = 1:3] rows(packs, word(ways, i)) using "N":(100*column("g_sd")):(100*column("g_sd_err")) with yerrorlines lt int(word(inks, i)) lw 1 pt int(word(forms, i)) ps 0.5, \
      for [i = 1:3] rows(packs, word(ways, i)) using "N":(100*column("contact_sd")) with lines lt int(word(inks, i)) dt 3 lw 1.4
  } else {
    plot for [i = 1:3] rows(packs, word(ways, i)) using "N":(100*column("g_sd")):(100*column("g_sd_err")) with yerrorlines lt int(word(inks, i)) lw 1 pt int(word(forms, i)) ps 0.5
  }
  do for [i = 1:6] { unset label i }
}
unset multiplot
