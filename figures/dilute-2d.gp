# Discs by gravity, diluted by moves of three ranges, coloured by the distance of the nearest other surface.
# data: dilute-2d
set terminal cairolatex pdf size 14.2cm,6.5cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin screen 0; set rmargin screen 1; set tmargin screen 1; set bmargin screen 0
rim = 43; apart = 2 * rim
set xrange [-rim:2 * apart + rim]; set yrange [-74:44]
set palette maxcolors 40 defined (0 "#08306b", 0.25 "#2171b5", 0.6 "#8cc0e0", 1 "#d3e4f2")
set cbrange [0:0.4]
set colorbox horizontal user origin screen 0.36,screen 0.13 size screen 0.28,screen 0.025 noborder front
set cbtics 0.1 scale 0.4 offset 0,0.5
found(quantity) = real(system(sprintf("awk '$1 == \"%s\" { print $2 }' %s", quantity, data("dilute-2d", "summary.tsv"))))
runs = "surfaces@0 surfaces@1 centres@1"
moves(x) = x > 0 ? sprintf("moves up to $%.2f\\,a$", x) : "no moves"
set for [s = 0:2] label 1 + s moves(found("moves@".word(runs, s + 1))) at s * apart, -50 center front
set label 5 "distance of the nearest surface, in diameters" at screen 0.5,screen 0.02 center front
plot for [s = 0:2] "< awk -f figures/cut.awk ".data("dilute-2d", "pack-0@".word(runs, s + 1).".xyz") using ($1 + s * apart):2:3:5 with circles fs solid noborder lc palette
