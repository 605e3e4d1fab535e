# A ball of spheres of two sizes by gravity, an octant cut out towards the eye; far ones first, each with its light.
# data: gravity-3d
set terminal cairolatex pdf size 9.4cm,9.4cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-22.5:22.5]; set yrange [-22.5:22.5]
shade(species, q) = species == 2 ? 65536*int(150+90*q)+256*int(60+120*q)+int(10+100*q) : 65536*int(20+150*q)+256*int(70+140*q)+int(130+115*q)
# in units in which the ball is as deep as the light and its fog
f = data("gravity-3d", "pack-0.xyz")
rim = real(system("sed -n '2s/.* open=\\([0-9.]*\\) .*/\\1/p' ".f))
scaled = sprintf("awk -v s=%.6f 'BEGIN {OFS = \"\\t\"} {print $1*s, $2*s, $3*s, $4*s, $5}'", 22 / rim)
plot "< awk -v cut=1 -f figures/spheres.awk ".f." | ".scaled." | sort -gr -k1,1 | awk -f figures/seen.awk | sort -g -k1,1 | awk -f figures/light.awk" \
  using 1:2:3:(shade($5, $4)) with circles fs solid noborder lc rgb variable
