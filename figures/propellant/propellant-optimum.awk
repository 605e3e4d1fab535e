# from: propellant-one/summary.tsv propellant/sweep.tsv
# propellant-optimum.awk: the densest pack of two sizes. From the sweep of propellant, and the jammed fraction of one size
# from propellant-one: for each size of the fine the maximum of a cubic in the coarse share X, by least squares
# through the five points about the highest; and the line through the maxima of the three smallest, carried on to size
# zero. All points weigh alike, with the mean of their squared standard errors. coarse@R@P: how many coarse spheres;
# coarse_fills, fine_fills: the share of the box that these fill, and of the rest that the fine fill; layer: the depth of
# the empty layer about coarse spheres in diameters of the fine, and its mean over the same three at equal volumes.
function row(name, value, error) { printf "%s\t%.12g\t%s\n", name, value, error == "" ? 0 : sprintf("%.12g", error) }
function least(a, b) { return a < b ? a : b }
# Solve the four normal equations s[i + j] c[j] = t[i]; v becomes the inverse of s.
function solve(   i, j, k, f) {
  for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) { m[i, j] = s[i + j]; v[i, j] = i == j }
  for (k = 0; k < 4; k++) {
    f = m[k, k]
    for (j = 0; j < 4; j++) { m[k, j] /= f; v[k, j] /= f }
    for (i = 0; i < 4; i++) if (i != k) {
      f = m[i, k]
      for (j = 0; j < 4; j++) { m[i, j] -= f * m[k, j]; v[i, j] -= f * v[k, j] }
    }
  }
  for (i = 0; i < 4; i++) for (c[i] = j = 0; j < 4; j++) c[i] += v[i, j] * t[j]
}
# The cubic of size r through its points first to first + 4, with u = X less that of the middle one.
function cubic(r, first,   i, j, u, noise, peak, bend, square) {
  for (j = 0; j < 7; j++) s[j] = 0
  for (j = 0; j < 4; j++) t[j] = 0
  for (i = first; i < first + 5; i++) {
    u = x[r, i] - x[r, first + 2]; noise += e[r, i] ^ 2 / 5
    for (j = 0; j < 7; j++) s[j] += u ^ j
    for (j = 0; j < 4; j++) t[j] += y[r, i] * u ^ j
  }
  solve()
  bend = c[2] * c[2] - 3 * c[1] * c[3]
  peak = c[1] / (sqrt(bend > 0 ? bend : 0) - c[2])
  best_x[r] = x[r, first + 2] + peak; best[r] = c[0] + peak * (c[1] + peak * (c[2] + peak * c[3]))
  bend = 2 * c[2] + 6 * c[3] * peak # dX/dc[j] = -j peak^(j - 1)/bend
  for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) {
    error[r] += noise * v[i, j] * peak ^ (i + j)
    if (i && j) x_error[r] += noise * v[i, j] * i * j * peak ^ (i + j - 2) / bend ^ 2
  }
  error[r] = sqrt(error[r]); x_error[r] = sqrt(x_error[r])
}
BEGIN { FS = "\t"; print "# maxima over the coarse share; written by propellant-optimum.awk"; print "quantity\tvalue\tstandard_error" }
FNR == 1 { file++; named = 0 }
/^#/ { next }
!named {
  named = 1; for (i = NF; i > 0; i--) k[$i] = i
  for (i = split(file == 1 ? "quantity value standard_error" : "species.[1].radius species.[0].volume number fraction fraction_err", need, " "); i > 0; i--)
    if (!(need[i] in k)) { print "propellant-optimum.awk: " FILENAME ": no column " need[i] > "/dev/stderr"; failed = 1; exit 1 }
  next
}
file == 1 { if ($k["quantity"] == "fraction@0.03@2000") { phi0 = $k["value"]; phi0_error = $k["standard_error"] }; next }
{
  r = $k["species.[1].radius"]; w = $k["species.[0].volume"]
  if (!(r in count)) size[sizes++] = r
  i = count[r]++
  x[r, i] = w / (1 + w); y[r, i] = $k["fraction"]; e[r, i] = $k["fraction_err"]
  phi1 = x[r, i] * y[r, i]; phi2 = y[r, i] - phi1; at = r "@" w; X = x[r, i]
  row("coarse@" at, int($k["number"] * w / (w + r ^ -3) + 0.5))
  row("coarse_fills@" at, phi1, X * e[r, i]); row("fine_fills@" at, phi2 / (1 - phi1), (1 - X) / (1 - phi1) ^ 2 * e[r, i])
  row("layer@" at, layer = ((1 - phi1) * phi0 - phi2) / (6 * phi0 * phi1 * r), e[r, i] / (6 * phi1 * y[r, i] * r))
  if (w == 1) depth[r] = layer
  if (!(r in top) || y[r, i] > y[r, top[r]]) top[r] = i
}
END {
  if (failed) exit 1
  furnas = phi0 * (2 - phi0)
  row("one_size", phi0, phi0_error); row("furnas_X", 1 / (2 - phi0), phi0_error / (2 - phi0) ^ 2)
  row("furnas", furnas, 2 * (1 - phi0) * phi0_error)
  for (n = 0; n < sizes; n++) {
    r = size[n]; cubic(r, top[r] < 2 ? 0 : least(top[r] - 2, count[r] - 5))
    row("X@" r, best_x[r], x_error[r]); row("fraction@" r, best[r], error[r])
    row("short@" r, furnas - best[r], error[r])
  }
  noise = 0
  for (n = sizes - 3; n < sizes; n++) {
    r = size[n]; s0++; s1 += r; s2 += r * r; t0 += best[r]; t1 += r * best[r]; noise += error[r] ^ 2 / 3
    layer1 += depth[r] / 3; layer2 += depth[r] ^ 2 / 3
  }
  d = s0 * s2 - s1 * s1; slope = (s0 * t1 - s1 * t0) / d
  row("slope", -slope, sqrt(noise * s0 / d)); row("fraction@0", (s2 * t0 - s1 * t1) / d, sqrt(noise * s2 / d))
  spread = layer2 - layer1 * layer1; spread = spread > 0 ? sqrt(spread / 2) : 0
  row("layer", layer1, spread); row("layer_slope", 6 * layer1 * phi0 * phi0, 6 * phi0 * phi0 * spread)
}
