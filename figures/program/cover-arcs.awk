# figures/program/cover-arcs.awk, after pen.awk and pack.awk: superellipses that overlap, what of each boundary is exposed, where boundaries cross, and what of the line x = 0
# is covered.
FNR > 2 { N = particle; px[N] = x; py[N] = y; tx[N] = cos($place["angle"]); ty[N] = sin($place["angle"]) }
function power(v, p) { return v == 0 ? 0 : (v < 0 ? -v : v) ^ p }
# A point of the boundary of i at the parameter t, of its copy (a, b).
function boundary(i, a, b, t,   c, s, u, v) {
  c = cos(t); s = sin(t); u = A * (c < 0 ? -1 : 1) * power(c, 1 / m); v = B * (s < 0 ? -1 : 1) * power(s, 1 / m)
  bx = px[i] + a * X + tx[i] * u - ty[i] * v; by = py[i] + b * Y + ty[i] * u + tx[i] * v
}
function inside(j, a, b, x, y,   u, v) {
  x -= px[j] + a * X; y -= py[j] + b * Y; u = tx[j] * x + ty[j] * y; v = tx[j] * y - ty[j] * x
  return power(u / A, 2 * m) + power(v / B, 2 * m) < 1
}
# Is the point in any but the copy (a0, b0) of i?
function hidden(x, y, i, a0, b0,   j, a, b) {
  for (j = 1; j <= N; j++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++)
    if (!(j == i && a == a0 && b == b0) && inside(j, a + shift_x, b + shift_y, x, y)) return 1
  return 0
}
function is_hidden(i, t) { boundary(i, 0, 0, t); shift_x = shift_y = 0; return hidden(bx, by, i, 0, 0) }
# The root between t0 and t1, by halving.
function root(i, t0, t1,   h, k, t) {
  h = is_hidden(i, t0)
  for (k = 0; k < 30; k++) { t = (t0 + t1) / 2; if (is_hidden(i, t) == h) t0 = t; else t1 = t }
  return t0
}
# An arc of i and its images in the box.
function put(i, t0, t1, exposed,   n, k, row, a, b) {
  n = int((t1 - t0) / (exposed ? 0.15 : 0.2)) + 1
  for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    if (!seen(i, a, b)) continue
    row = "curve" OFS (exposed ? blue : "808080") OFS (exposed ? 1.6 : 0.5)
    for (k = 0; k <= n; k++) { boundary(i, a, b, t0 + (t1 - t0) * k / n); row = row OFS bx OFS by }
    print row
  }
}
function seen(i, a, b,   u, v) { u = px[i] + a * X; v = py[i] + b * Y; return u > -1.6 && u < X + 1.2 && v > -1.2 && v < Y + 1.2 }
END {
  m = 1.5; A = 1.6; B = 1
  # The axes of area pi, by a polygon.
  area = 0; for (k = 0; k < 4000; k++) { t = 2 * pi * k / 4000; c = A * (cos(t) < 0 ? -1 : 1) * power(cos(t), 1 / m); s = B * (sin(t) < 0 ? -1 : 1) * power(sin(t), 1 / m); if (k) area += (c0 * s - c * s0) / 2; else { c1 = c; s1 = s }; c0 = c; s0 = s }
  area += (c0 * s1 - c1 * s0) / 2; f = sqrt(pi / area); A *= f; B *= f
  window(-0.6, -0.4, X + 0.4, Y + 0.4); print "clip", -0.6, -0.4, X + 0.4, Y + 0.4
  row = ""; for (k = 0; k < 44; k++) { t = 2 * pi * k / 44; row = row OFS A * (cos(t) < 0 ? -1 : 1) * power(cos(t), 1 / m) OFS B * (sin(t) < 0 ? -1 : 1) * power(sin(t), 1 / m) }
  print "outline", "CA" row
  print "clip"; print "clip", -0.6, -0.4, X + 0.4, Y + 0.4
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) if (seen(i, a, b)) print "shape", "CA", "dcebf6", "dcebf6", 0.4, px[i] + a * X, py[i] + b * Y, 1, tx[i], ty[i]
  for (i = 1; i <= N; i++) {
    roots = 0; h = is_hidden(i, 0.001)
    for (k = 1; k <= 240; k++) { t = 0.001 + 2 * pi * k / 240; now = is_hidden(i, t); if (now != h) { cross[++roots] = root(i, t - 2 * pi / 240, t); open[roots] = h; h = now } }
    if (!roots) { if (!h) put(i, 0, 2 * pi, 1); continue }
    cross[roots + 1] = cross[1] + 2 * pi
    for (k = 1; k <= roots; k++) put(i, cross[k], cross[k + 1], open[k])
    for (k = 1; k <= roots; k++) { for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) if (seen(i, a, b)) { boundary(i, a, b, cross[k]); ends++; ex[ends] = bx; ey[ends] = by } }
  }
  frame(black, 0, 0, X, Y, 0.8)
  # The covered part of the line x = 0.
  for (k = 0; k <= 700; k++) {
    now = k < 700 && hidden(-1e-9, k * Y / 700, 0, 0, 0)
    if (now && !was) y0 = k * Y / 700
    if (!now && was) { line(red, 0, y0, 0, k * Y / 700, 2.4); label = y0 + 0.86 * (k * Y / 700 - y0) }
    was = now
  }
  for (k = 1; k <= ends; k++) if (!doubled(k)) dot(black, ex[k], ey[k], 1.9)
  print "clip"; words(-0.3, label, "$\\ell$")
}
# The same corner, of the other of the two?
function doubled(k,   l) { for (l = 1; l < k; l++) if ((ex[l] - ex[k]) ^ 2 + (ey[l] - ey[k]) ^ 2 < 1e-6) return 1; return 0 }
