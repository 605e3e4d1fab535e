# A pack of discs at saturation, with the images that reach over the sides.
# data: pack-2d
set terminal cairolatex pdf size 12.6cm,8.2cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin screen 0; set rmargin screen 1; set tmargin screen 1; set bmargin screen 0
# Circles are drawn only if their centres are in range, so the range is wider than the box, and a mask covers the rest.
set xrange [-1.01:41.01]; set yrange [-1.01:26.01]
set for [i = 0:1] object 1 + i rectangle from (i ? 40 : -2.1),-2.1 to (i ? 42.1 : 0),27.1 noclip fs solid noborder fc rgb "white" front
set for [i = 0:1] object 3 + i rectangle from -2.1,(i ? 25 : -2.1) to 42.1,(i ? 27.1 : 0) noclip fs solid noborder fc rgb "white" front
set object 5 rectangle from 0,0 to 40,25 fs empty border lc rgb "#777777" lw 0.6 front
plot "< awk -f figures/discs.awk build/data/pack-2d/pack-0.xyz" using 1:2:3 with circles fs solid 0.35 border lc rgb "#0072b2" fc rgb "#56b4e9"
