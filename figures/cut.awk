# figures/cut.awk: the discs of a finite pack that reach into the square of the side 2 half about its middle, without half all discs:
# x y r species gap, with species 1 the first in the file, and gap the part of the distance of the centres by which the nearest other disc
# is apart, 1 at most. A disc outside the square may be the nearest of one inside, so it is looked for in the whole pack, by cells.
function cell(v) { return int(v / wide) }
/Lattice=/ { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), L, " "); next }
NR > 2 {
  n++; x[n] = $2; y[n] = $3; r[n] = $5; if (n == 1) first = $1
  kind[n] = $1 == first ? 1 : 2; if ($5 > largest) largest = $5
}
END {
  OFS = "\t"; wide = 4 * largest
  for (i = 1; i <= n; i++) { k = cell(x[i]) " " cell(y[i]); inside[k] = inside[k] " " i }
  for (i = 1; i <= n; i++) {
    u = x[i] - L[1] / 2; v = y[i] - L[5] / 2
    if (half && (u < 0 ? -u : u) >= half + r[i] || half && (v < 0 ? -v : v) >= half + r[i]) continue
    gap = 1
    for (k = -1; k <= 1; k++) for (l = -1; l <= 1; l++) {
      m = split(inside[cell(x[i]) + k " " cell(y[i]) + l], near, " ")
      for (q = 1; q <= m; q++) if ((j = near[q]) != i) {
        g = sqrt((x[i] - x[j]) ^ 2 + (y[i] - y[j]) ^ 2) / (r[i] + r[j]) - 1
        if (g < gap) gap = g
      }
    }
    print u, v, r[i], kind[i], gap
  }
}
