# Spheres by Fuller's curve, seen from a corner, coloured by size; far ones first, each with its light.
# data: sizes-fuller
set terminal cairolatex pdf size 9.4cm,8cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-15:15]; set yrange [-14.2:14.2]
shade(class, q) = class == 1 ? 65536*int(20+150*q)+256*int(70+140*q)+int(130+115*q) : class == 2 ? 65536*int(10+120*q)+256*int(95+125*q)+int(75+120*q) : 65536*int(150+90*q)+256*int(60+120*q)+int(10+100*q)
# in units in which the box is as large as that of pack-grown, for the light
scaled = "awk 'BEGIN {OFS = \"\\t\"} {class = $4 < 2 ? 1 : $4 < 4.5 ? 2 : 3; print $1/3.383, $2/3.383, $3/3.383, $4/3.383, class}'"
plot "< awk -f figures/spheres.awk build/data/sizes-fuller/pack-0.xyz | ".scaled." | sort -gr -k1,1 | awk -f figures/seen.awk | sort -g -k1,1 | awk -f figures/light.awk" \
  using 1:2:3:(shade($5, $4)) with circles fs solid noborder lc rgb variable
