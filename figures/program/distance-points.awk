# figures/program/distance-points.awk, after pen.awk and pack.awk: points among superellipses, the least signed distance from each to a boundary, and a circle of that radius.
FNR > 2 { N = particle; px[N] = x; py[N] = y; tx[N] = cos($place["angle"]); ty[N] = sin($place["angle"]) }
function power(v, p) { return v == 0 ? 0 : (v < 0 ? -v : v) ^ p }
function at_angle(t,   c, s) { c = cos(t); s = sin(t); bu = A * (c < 0 ? -1 : 1) * power(c, 1 / m); bv = B * (s < 0 ? -1 : 1) * power(s, 1 / m) }
# The least signed distance, below zero in a particle, over the images of the particles, and the point (hit_x, hit_y) of the boundary.
function probe(x, y,   i, a, b, k, u, v, d, least, c, own, q, r) {
  least = c = 99
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    u = px[i] + a * X; v = py[i] + b * Y; d = sqrt((u - x) ^ 2 + (v - y) ^ 2); if (d > 3.5) continue
    if (d < c) { c = d; centre_x = u; centre_y = v }
    own = 99
    for (k = 0; k < 720; k++) { d = (u + tx[i] * U[k] - ty[i] * V[k] - x) ^ 2 + (v + ty[i] * U[k] + tx[i] * V[k] - y) ^ 2; if (d < own) { own = d; q = k } }
    r = tx[i] * (x - u) + ty[i] * (y - v); d = tx[i] * (y - v) - ty[i] * (x - u)
    own = power(r / A, 2 * m) + power(d / B, 2 * m) < 1 ? -sqrt(own) : sqrt(own)
    if (own < least) { least = own; hit_x = u + tx[i] * U[q] - ty[i] * V[q]; hit_y = v + ty[i] * U[q] + tx[i] * V[q]; near_x = u; near_y = v }
  }
  if (least < 0) least = -least
  dash(2, 2); ring(red, x, y, least, 0.8); dash(); line(red, x, y, hit_x, hit_y, 1.3); dot(red, x, y, 1.9); dot(black, hit_x, hit_y, 1.7)
  if ((near_x - centre_x) ^ 2 + (near_y - centre_y) ^ 2 > 1e-9) { dash(1, 1.5); line(grey, x, y, centre_x, centre_y, 0.8); dash(); dot(grey, centre_x, centre_y, 1.5) }
}
END {
  m = 1.5; A = 1.6; B = 1; f = 0
  for (k = 0; k <= 4000; k++) { u = bu; v = bv; at_angle(2 * pi * k / 4000); if (k) f += (u * bv - bu * v) / 2 }
  f = sqrt(pi / f); A *= f; B *= f
  for (k = 0; k < 720; k++) { at_angle(2 * pi * k / 720); U[k] = bu; V[k] = bv }
  window(-0.05, -0.05, X + 0.05, Y + 0.05); print "clip", 0, 0, X, Y
  for (k = 0; k < 720; k += 15) row = row OFS U[k] OFS V[k]
  print "clip"; print "outline", "DP" row; print "clip", 0, 0, X, Y
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > -1.5 && u < X + 1.5 && v > -1.5 && v < Y + 1.5) print "shape", "DP", light, blue, 0.7, u, v, 1, tx[i], ty[i] }
  split(points, place_of, " ")
  for (k = 1; (2 * k) in place_of; k++) probe(place_of[2 * k - 1], place_of[2 * k])
  print "clip"; frame(black, 0, 0, X, Y, 0.8)
}
