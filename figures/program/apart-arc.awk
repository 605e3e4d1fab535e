# figures/program/apart-arc.awk, after pen.awk and pack.awk: two triangles of a pack, and the search for a direction that parts them, among the differences of their points.
FNR > 2 { N = particle; px[N] = x; py[N] = y; turn[N] = $place["angle"] }
function corner(i, k) { cx = size * cos(turn[i] + 2 * pi * k / 3); cy = size * sin(turn[i] + 2 * pi * k / 3) }
# The difference of two points that is least along the angle t: gap is f, (wx, wy) the difference, (ax, ay) and (bx, by) the points.
function support(t,   k, c, s, h, g) {
  c = cos(t); s = sin(t); h = -9; g = 9
  for (k = 0; k < 3; k++) { corner(i, k); if (cx * c + cy * s > h) { h = cx * c + cy * s; ax = cx; ay = cy } }
  for (k = 0; k < 3; k++) { corner(j, k); if ((dx + cx) * c + (dy + cy) * s < g) { g = (dx + cx) * c + (dy + cy) * s; bx = dx + cx; by = dy + cy } }
  wx = bx - ax; wy = by - ay; gap = g - h
}
function shape(i, x, y, fill, rim,   k, row) { row = "path" OFS fill OFS rim OFS 0.8; for (k = 0; k < 3; k++) { corner(i, k); row = row OFS x + cx OFS y + cy }; print row }
END {
  size = sqrt(2 * pi / (3 * sin(2 * pi / 3)))
  # Of all pairs that three steps part, the one with the widest gap.
  for (p = 1; p <= N; p++) for (q = 1; q <= N; q++) {
    if (p == q) continue
    i = p; j = q; dx = nearest(px[j] - px[i], X); dy = nearest(py[j] - py[i], Y); if (dx < 1 || dx * dx + dy * dy > 7) continue
    s = search(0); if (s == 3 && gap > most) { most = gap; I = i; J = j }
  }
  i = I; j = J; dx = nearest(px[j] - px[i], X); dy = nearest(py[j] - py[i], Y)
  window(-1.7, -3, 10.8, 3)
  search(1)
}
# Directions are tried until one parts i and j: how many. With draw they are drawn.
function search(draw,   t, low, high, steps, a, k, row, last) {
  t = atan2(dy, dx); low = t - pi; high = t + pi; gap = -1
  while (gap <= 0 && steps < 9) {
    steps++; support(t); tried[steps] = t; qx[steps] = wx; qy[steps] = wy
    if (gap > 0) break
    a = atan2(wy, wx); a += 2 * pi * int((t - a) / (2 * pi) + (t > a ? 0.5 : -0.5))
    if (a - pi / 2 > low) low = a - pi / 2; if (a + pi / 2 < high) high = a + pi / 2
    if (low >= high) return 0
    t = (low + high) / 2
  }
  if (!draw) return steps
  oy = -dy / 2; ox = 0
  shape(i, ox, oy, light, blue); shape(j, ox + dx, oy + dy, cream, brown)
  dot(blue, ox, oy, 1.6); dot(brown, ox + dx, oy + dy, 1.6); dash(2, 2); line(grey, ox, oy, ox + dx, oy + dy, 0.7); dash()
  a = (ax + bx) / 2; k = (ay + by) / 2
  line(red, ox + a - 1.9 * sin(t), oy + k + 1.9 * cos(t), ox + a + 1.9 * sin(t), oy + k - 1.9 * cos(t), 1.1)
  dot(black, ox + ax, oy + ay, 1.8); dot(black, ox + bx, oy + by, 1.8)
  # the differences: corners in the order of directions
  zx = 6; zy = -dy
  for (k = 0; k < 360; k++) { support(k * pi / 180); if (wx "" wy != last) { row = row OFS zx + wx OFS zy + wy; last = wx "" wy } }
  print "path", "e8e8e8", grey, 0.8 row
  for (k = 1; k < steps; k++) { arrow("505050", zx, zy, zx + qx[k], zy + qy[k], 0.9); a = sqrt(qx[k] ^ 2 + qy[k] ^ 2); words(zx + qx[k] * (1 + 0.32 / a), zy + qy[k] * (1 + 0.32 / a), "$\\mathbf w_" k "$") }
  t = tried[steps]; arc(green, zx, zy, 0.9, low, high, 1.6); arrow(red, zx, zy, zx + 0.9 * cos(t), zy + 0.9 * sin(t), 1.2); words(zx + 1.15 * cos(t), zy + 1.15 * sin(t), "$\\mathbf v$")
  dot(black, zx, zy, 2.2)
  dash(3, 2); line(red, zx - 1.4 * sin(t), zy + 1.4 * cos(t), zx + 1.4 * sin(t), zy - 1.4 * cos(t), 0.9); dash()
  return steps
}
