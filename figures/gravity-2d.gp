# Squares from the cores of two packs of discs by gravity: coarse ones added, and marked. Discs without a contact are lighter.
# data: gravity-2d gravity-2d-mark
set terminal cairolatex pdf size 13.4cm,6.9cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin screen 0.01; set rmargin screen 0.99; set tmargin screen 0.98; set bmargin screen 0.02
half = 24; reach = 3.1; apart = 2 * half + 2 * reach
# Circles are drawn only if their centres are in range, so the range is wider than the squares, and a mask covers the rest.
set xrange [-half - reach:apart + half + reach]; set yrange [-half - 2 * reach:half + reach]
set style rectangle fs solid noborder fc rgb "white"
set for [s = 0:1] object 1 + s rectangle from s * apart + half, -99 to s * apart + half + 2 * reach, 99 noclip front
set object 3 rectangle from -half - 9, -99 to -half, 99 noclip front
set for [s = 0:1] object 4 + s rectangle from -99, (s == 1 ? half : -half - 9) to apart + 99, (s == 1 ? half + 9 : -half) noclip front
set for [s = 0:1] object 6 + s rectangle from s * apart - half, -half to s * apart + half, half fs empty border lc rgb "#777777" lw 0.6 front
set label 1 "coarse discs added" at 0, -half - 3.2 center front
set label 2 "coarse discs marked" at apart, -half - 3.2 center front
cut(scene) = sprintf("< awk -v half=%g -f figures/cut.awk %s", half, data(scene, "pack-0.xyz"))
fill(species, gap) = gap <= 1e-6 ? (species == 1 ? 0x8cc8ec : 0xe07b28) : (species == 1 ? 0xffffff : 0xfbe3d0)
line(species) = species == 1 ? 0x0072b2 : 0x8a3c00
plot for [s = 0:1] cut(s == 1 ? "gravity-2d-mark" : "gravity-2d") using ($1 + s * apart):2:3:(fill($4, $5)) with circles fs solid noborder lc rgb variable, \
  for [s = 0:1] cut(s == 1 ? "gravity-2d-mark" : "gravity-2d") using ($1 + s * apart):2:3:(line($4)) with circles fs empty border lw 0.5 lc rgb variable
