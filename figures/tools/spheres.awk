# figures/tools/spheres.awk, after pack.awk: a pack in 3-D seen from a corner: depth, x, y, r and what is seen of it.
# Spheres that do not overlap are separated by a plane, and the one whose centre is nearer to the eye lies on the plane's near side; so
# the order of the centres is that in which they cover each other, for unequal spheres too.
# With cut, the radius of a ball, those with centres in the octant towards the eye, seen from the middle, are left out.
# What is seen is the kind; with classes, two radii, the class of the size, 1 to 3; with cut the kind and a digit: 0 if it is looked at
# from outside, or 1 to 3, the plane of the cut behind which it is: the last of the three that the line from it to the eye crosses.
BEGIN {
  OFS = "\t"; split(classes, class, " ")
  ca = 0.8253356149; sa = 0.5646424734; ce = 0.8775825619; se = 0.4794255386 # turned by .6, seen from .5 above
}
FNR > 2 {
  x -= X / 2; y -= Y / 2; z -= Z / 2
  if (cut && x > 0 && y > 0 && z > 0) next
  u = ca * x - sa * y; d = sa * x + ca * y
  printf "%.6f\t%.5f\t%.5f\t%.6g\t%s\n", ce * d + se * z, u, ce * z - se * d, r, cut ? kind face() : classes ? 1 + (r >= class[1]) + (r >= class[2]) : kind
}
function face(   t, k, a, b, c) {
  t = -x / (ce * sa); k = 1
  if (-y / (ce * ca) > t) { t = -y / (ce * ca); k = 2 }
  if (-z / se > t) { t = -z / se; k = 3 }
  a = x + t * ce * sa; b = y + t * ce * ca; c = z + t * se
  return a * a + b * b + c * c < cut * cut ? k : 0
}
