# The modules of the book and who includes whom, from the tangled C.
# data: build/map.tsv
kind(k) = columns("where=kind=".k." build/map.tsv")
# As high as the longest part needs.
stats kind("module") using (column("y")) name "row" nooutput
set terminal cairolatex pdf size 13.8cm,(1.6 - row_min) * 1.02 cm font ",9"
set output out
unset border; unset tics; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-0.95:10.95]; set yrange [row_min - 0.5:1.1]
set style arrow 1 head filled size screen 0.009,18 lw 0.6 lc rgb "#8a97a8"
plot kind("arrow") using "x":"y":"dx":"dy" with vectors arrowstyle 1, \
  kind("module") using "x":"y":(0.47):(0.2) with boxxyerror fs solid 1 fc rgb "#eef3f8" lc rgb "#0072b2" lw 0.8, \
  kind("module") using "x":"y":('\\ttfamily '.stringcolumn("words")) with labels, \
  kind("part") using "x":"y":('\\scshape '.stringcolumn("words")) with labels
