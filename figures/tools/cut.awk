# figures/tools/cut.awk, after pack.awk: the discs of a finite pack that reach into the square of the side 2 half about its middle, without half
# all discs: x y r kind gap, gap being the part of the distance of the centres by which the nearest other disc is apart, 1 at most.
# A disc outside the square may be the nearest of one inside, so it is looked for in the whole pack, by cells.
function cell(v) { return int(v / wide) }
FNR > 2 { u[particle] = x; v[particle] = y; radius[particle] = r; sort[particle] = kind; if (r > largest) largest = r }
END {
  wide = 4 * largest
  for (i = 1; i <= particle; i++) { k = cell(u[i]) " " cell(v[i]); inside[k] = inside[k] " " i }
  for (i = 1; i <= particle; i++) {
    x = u[i] - X / 2; y = v[i] - Y / 2; r = radius[i]
    if (half && (x < 0 ? -x : x) >= half + r || half && (y < 0 ? -y : y) >= half + r) continue
    gap = 1
    for (k = -1; k <= 1; k++) for (l = -1; l <= 1; l++) {
      m = split(inside[cell(u[i]) + k " " cell(v[i]) + l], near, " ")
      for (q = 1; q <= m; q++) if ((j = near[q]) != i) {
        dx = u[i] - u[j]; dy = v[i] - v[j]; g = sqrt(dx * dx + dy * dy) / (r + radius[j]) - 1
        if (g < gap) gap = g
      }
    }
    print x "\t" y "\t" r "\t" sort[i] "\t" gap
  }
}
