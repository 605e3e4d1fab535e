# A ball of spheres of two sizes by gravity, an octant cut out towards the eye; far ones first, each with its light.
# data: gravity-3d
set terminal cairolatex pdf size 9.4cm,9.4cm font ",10"
set output out
unset tics; unset key; unset border
set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-22.5:22.5]; set yrange [-22.5:22.5]
# Outside they are pale; of the three planes of the cut each has a light of its own. The rim of a sphere has q = 0.
light(face, q) = (face == 0 ? 0.95 : face == 1 ? 0.68 : face == 2 ? 0.85 : 1.0) * (face == 0 ? 0.78 + 0.3 * sqrt(q) : 0.62 + 0.5 * sqrt(q))
mix(c, face, q) = int((face == 0 ? 0.35 * c + 0.65 * 235 : c + 30) * light(face, q) + (face == 0 ? 15 : 30) * q)
rgb(r, g, b, face, q) = 65536 * mix(r, face, q) + 256 * mix(g, face, q) + mix(b, face, q)
shade(species, face, q) = species == 2 ? rgb(185, 85, 10, face, q) : rgb(40, 115, 175, face, q)
# in units in which the ball is as deep as the light and its fog
f = data("gravity-3d", "pack-0.xyz")
rim = real(system("sed -n '2s/.* open=\\([0-9.]*\\) .*/\\1/p' ".f))
scaled = sprintf("awk -v s=%.6f 'BEGIN {OFS = \"\\t\"} {print $1*s, $2*s, $3*s, $4*s, $5 + 2*$6, $5 == 2 ? 6 : $6 ? 3 : 2}'", 22 / rim)
plot sprintf("< awk -v cut=%g -f figures/spheres.awk ", rim).f." | ".scaled." | sort -gr -k1,1 | awk -f figures/seen.awk | sort -g -k1,1 | awk -f figures/light.awk" \
  using 1:2:3:(shade(int($5 - 1) % 2 + 1, int($5 - 1) / 2, $4)) with circles fs solid noborder lc rgb variable
