# figures/spheres.awk: a pack in 3-D seen from a corner, by the painter's rule: far spheres first.
# Spheres that do not overlap are separated by a plane, and the one whose centre is nearer to the eye
# lies on the plane's near side; so drawing them in the order of their centres is exact, for unequal spheres too.
# With cut, the radius of a ball, those with centres in the octant towards the eye, seen from the middle, are left out.
# Prints depth x y r species, which is 1 for the first in the file and 2 for others, and with cut 0 if its centre is looked at from outside,
# or 1 to 3, the plane of the cut behind which it is: the last of the three that the line from it to the eye crosses, if in the ball.
BEGIN { ca = cos(0.6); sa = sin(0.6); ce = cos(0.5); se = sin(0.5) }
/Lattice=/ { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), L, " "); next }
NR > 2 {
  x = $2 - L[1] / 2; y = $3 - L[5] / 2; z = $4 - L[9] / 2
  if (first == "") first = $1
  if (cut && x > 0 && y > 0 && z > 0) next
  u = ca * x - sa * y; d = sa * x + ca * y
  printf "%.6f\t%.5f\t%.5f\t%s\t%d%s\n", ce * d + se * z, u, ce * z - se * d, $5, $1 == first ? 1 : 2, cut ? "\t" face() : ""
}
function face(   t, k) {
  t = -x / (ce * sa); k = 1
  if (-y / (ce * ca) > t) { t = -y / (ce * ca); k = 2 }
  if (-z / se > t) { t = -z / se; k = 3 }
  return (x + t * ce * sa) ^ 2 + (y + t * ce * ca) ^ 2 + (z + t * se) ^ 2 < cut ^ 2 ? k : 0
}
