# A pack of equal spheres grown to .60, seen from a corner; far ones first, each with its light.
# data: pack-grown
set terminal cairolatex pdf size 9.4cm,8cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-15:15]; set yrange [-14.2:14.2]
shade(q) = 65536*int(20+150*q)+256*int(70+140*q)+int(130+115*q)
plot "< awk -f figures/spheres.awk build/data/pack-grown/pack-0.xyz | sort -g -k1,1 | awk -f figures/light.awk" \
  using 1:2:3:(shade($4)) with circles fs solid noborder lc rgb variable
