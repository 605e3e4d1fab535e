# figures/spheres.awk: a pack in 3-D seen from a corner, by the painter's rule: far spheres first.
# Spheres that do not overlap are separated by a plane, and the one whose centre is nearer to the eye
# lies on the plane's near side; so drawing them in the order of their centres is exact.
# Prints x y r shade depth; several discs a sphere, for the light.
BEGIN { ca = cos(0.6); sa = sin(0.6); ce = cos(0.5); se = sin(0.5) }
/Lattice=/ { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), L, " "); next }
NR > 2 {
  x = $2 - L[1] / 2; y = $3 - L[5] / 2; z = $4 - L[9] / 2
  u = ca * x - sa * y; d = sa * x + ca * y
  printf "%.6f\t%.5f\t%.5f\t%s\t%.5f\n", ce * d + se * z, u, ce * z - se * d, $5, $1 == first || first == "" ? 1 : 2
  if (first == "") first = $1
}
