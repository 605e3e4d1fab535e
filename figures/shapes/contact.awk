# figures/shapes/contact.awk: pairs of shapes in overlap as bench ops writes them, overlap-pairs.tsv, as rows for paint.awk: the first pair with what it shares, its
# centroid and the normals; the same with a lattice of points; the second pair with its forces.
BEGIN { FS = OFS = "\t"; pi = 3.14159265358979; print "window", -1.5, -1.55, 11.3, 2.6; Z = 1 }
# Panels are drawn Z times as large about (ox, oy), which comes to (px, py).
function ux(x) { return px + Z * (x - ox) }
function uy(y) { return py + Z * (y - oy) }
/^#/ { next }
!head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{ row++; for (name in at) value[row, name] = $at[name] }
# The corners of a shape of area pi into X[b, k], Y[b, k], at (x, y) turned by the angle; n[b].
function outline(b, r, x, y, angle,   k, t, c, s, p, a, A, j, u, v, d) {
  n[b] = value[r, "sides"] ? value[r, "sides"] : 120; p = value[r, "m"] > 0 ? 1 / value[r, "m"] : 1; a = value[r, "aspect"] > 0 ? value[r, "aspect"] : 1; A = 0
  for (k = 0; k < n[b]; k++) {
    t = 2 * pi * k / n[b]; c = cos(t); s = sin(t)
    X[b, k] = a * (c < 0 ? -1 : 1) * (c < 0 ? -c : c) ^ p; Y[b, k] = (s < 0 ? -1 : 1) * (s < 0 ? -s : s) ^ p
  }
  for (k = 0; k < n[b]; k++) { j = (k + 1) % n[b]; A += (X[b, k] * Y[b, j] - X[b, j] * Y[b, k]) / 2 }
  d = sqrt(pi / A); c = cos(angle); s = sin(angle)
  for (k = 0; k < n[b]; k++) { u = d * X[b, k]; v = d * Y[b, k]; X[b, k] = x + c * u - s * v; Y[b, k] = y + s * u + c * v }
}
# The corners of body 3 that are inside body b: cut by each of its sides.
function clip(b,   i, j, k, m, f, g, s) {
  for (i = 0; i < n[b]; i++) {
    j = (i + 1) % n[b]; m = 0
    for (k = 0; k < n[3]; k++) {
      f = side(b, i, j, X[3, k], Y[3, k]); s = (k + 1) % n[3]; g = side(b, i, j, X[3, s], Y[3, s])
      if (f >= 0) { U[m] = X[3, k]; V[m++] = Y[3, k] }
      if ((f >= 0) != (g >= 0)) { U[m] = X[3, k] + f / (f - g) * (X[3, s] - X[3, k]); V[m++] = Y[3, k] + f / (f - g) * (Y[3, s] - Y[3, k]) }
    }
    for (k = 0; k < m; k++) { X[3, k] = U[k]; Y[3, k] = V[k] }
    n[3] = m
  }
}
function side(b, i, j, x, y) { return (X[b, j] - X[b, i]) * (y - Y[b, i]) - (Y[b, j] - Y[b, i]) * (x - X[b, i]) }
# How far a point is outside a body: the largest distance from a line of its sides.
function beyond(b, x, y,   i, j, f, most) {
  most = -9
  for (i = 0; i < n[b]; i++) { j = (i + 1) % n[b]; f = -side(b, i, j, x, y) / sqrt((X[b, j] - X[b, i]) ^ 2 + (Y[b, j] - Y[b, i]) ^ 2 + 1e-30); if (f > most) most = f }
  return most
}
function path(b, fill, rim,   k, s) { for (k = 0; k < n[b]; k++) s = s OFS ux(X[b, k]) OFS uy(Y[b, k]); print "path", fill, rim, 0.6 s }
function arrow(colour, x, y, u, v,   d, a, b) {
  d = sqrt(u * u + v * v); a = u / d; b = v / d
  print "line", colour, x, y, x + u, y + v, 1.2
  print "line", colour, x + u, y + v, x + u - 0.16 * a - 0.07 * b, y + v - 0.16 * b + 0.07 * a, 1.2
  print "line", colour, x + u, y + v, x + u - 0.16 * a + 0.07 * b, y + v - 0.16 * b - 0.07 * a, 1.2
}
function pair(r,   k) {
  outline(1, r, 0, 0, value[r, "angle_A"]); outline(2, r, value[r, "x"], value[r, "y"], value[r, "angle_B"])
  n[3] = n[1]; for (k = 0; k < n[1]; k++) { X[3, k] = X[1, k]; Y[3, k] = Y[1, k] }
  clip(2)
  path(1, "c4e5f7", "0072b2"); path(2, "f6d9b8", "8a4b08"); path(3, "d9a8c6", "803060")
  print "disc", "0072b2", ux(0), uy(0), 0.04; print "disc", "8a4b08", ux(value[r, "x"]), uy(value[r, "y"]), 0.04
}
function through(r, u, v, colour,   d, x, y) {
  d = sqrt(u * u + v * v); x = value[r, "area_x"]; y = value[r, "area_y"]
  print "line", colour, ux(x - 1.1 * u / d), uy(y - 1.1 * v / d), ux(x + 1.1 * u / d), uy(y + 1.1 * v / d), 0.8
}
END {
  if (row < 2) { print "contact.awk: two pairs are wanted" > "/dev/stderr"; exit 1 }
  pair(1)
  through(1, value[1, "x"], value[1, "y"], "777777"); through(1, value[1, "force_x"], value[1, "force_y"], "d55e00")
  print "disc", "000000", ux(value[1, "area_x"]), uy(value[1, "area_y"]), 0.05
  Z = 3.2; ox = value[1, "area_x"]; oy = value[1, "area_y"]; px = 5.1; py = 0.55
  print "clip", 3.6, -1.2, 6.6, 2.3
  pair(1)
  step = 0.06; layer = step / sqrt(2)
  for (x = ox - 0.6; x < ox + 0.6; x += step) for (y = oy - 0.7; y < oy + 0.7; y += step) {
    f = beyond(1, x, y); g = beyond(2, x, y); if (g > f) f = g
    print "disc", (f < 0 ? "c00000" : f < layer ? "e69f00" : "999999"), ux(x), uy(y), (f < layer ? 0.04 : 0.02)
  }
  print "disc", "000000", ux(ox), uy(oy), 0.06
  print "clip"
  print "line", "777777", 3.6, -1.2, 6.6, -1.2, 0.6; print "line", "777777", 6.6, -1.2, 6.6, 2.3, 0.6
  print "line", "777777", 6.6, 2.3, 3.6, 2.3, 0.6; print "line", "777777", 3.6, 2.3, 3.6, -1.2, 0.6
  Z = 1; ox = oy = 0; px = 8.4; py = 0
  pair(2)
  x = ux(value[2, "area_x"]); y = uy(value[2, "area_y"])
  arrow("d55e00", x, y, 0.9 * value[2, "force_x"], 0.9 * value[2, "force_y"]); arrow("d55e00", x, y, -0.9 * value[2, "force_x"], -0.9 * value[2, "force_y"])
  print "disc", "000000", x, y, 0.05
}
