# A pack of discs at saturation, with the images that reach over the sides.
# data: pack-2d
set terminal cairolatex pdf size 12.6cm,8.2cm font ",10"
set output out
unset tics; unset key; set border 15 lw 0.6 lc rgb "#777777"
set size ratio -1
set lmargin 0.5; set rmargin 0.5; set tmargin 0.3; set bmargin 0.3
set xrange [0:40]; set yrange [0:25]
plot "< awk -f figures/discs.awk build/data/pack-2d/pack-0.xyz" using 1:2:3 with circles fs solid 0.35 border lc rgb "#0072b2" fc rgb "#56b4e9"
