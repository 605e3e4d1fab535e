# Discs at .70 before and after shaking: filled, where they are, by the way they have gone; outlines, where they were.
# data: pack-shaken
set terminal cairolatex pdf size 10.6cm,9cm font ",10"
set output out
f = data("pack-shaken", "pack-0.xyz")
side = real(system(sprintf("sed -n '2s/^Lattice=\"\\([0-9.]*\\) .*/\\1/p' %s", f)))
moved = "< awk -f figures/moved.awk ".data("pack-shaken", "made.pack-0.xyz")." ".f
unset tics; unset key; unset border
set size ratio -1
set lmargin screen 0; set rmargin screen 0.849; set tmargin screen 1; set bmargin screen 0
# Circles are drawn only if their centres are in range, so the range is wider than the box, and a mask covers the rest.
from = -1.01; to = side + 1.01
set xrange [from:to]; set yrange [from:to]
set for [i = 0:1] object 1 + i rectangle from (i ? side : -2.1),-2.1 to (i ? side + 2.1 : 0),side + 2.1 noclip fs solid noborder fc rgb "white" front
set for [i = 0:1] object 3 + i rectangle from -2.1,(i ? side : -2.1) to side + 2.1,(i ? side + 2.1 : 0) noclip fs solid noborder fc rgb "white" front
set object 5 rectangle from 0,0 to side,side fs empty border lc rgb "#777777" lw 0.6 front
set palette defined (0 "#f4f8fb", 0.5 "#8cc0e0", 1 "#0072b2")
set colorbox user origin screen 0.875,screen 0.25 size screen 0.02,screen 0.5 noborder front
set cbtics 0.2 scale 0.4 offset -0.9,0; set cbrange [0:*]
set label "way gone, in radii" at screen 0.978,0.5 center rotate
way(x, y) = sqrt(x**2 + y**2)
plot moved using 1:2:3:(way($4, $5)) with circles fs solid noborder lc palette, \
  moved using ($1-$4):($2-$5):3 with circles fs empty border lc rgb "#444444" lw 0.7, \
  moved using ($1-$4):($2-$5):4:5 with vectors nohead lc rgb "#d55e00" lw 1.8, \
  moved using 1:2 with points pt 7 ps 0.18 lc rgb "#d55e00"
