# figures/program/rsa-voxels.awk, after pen.awk and pack.awk: a box while discs are added, at three moments: those that stand, what they exclude, and the voxels that no
# exclusion disc covers, cells at first and then halved so many times.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
# Is the square from (x, y), so wide, inside an exclusion disc of the first k? If not, is it to be cut?
function cut(x, y, wide, level,   i, u, v, a, b) {
  for (i = 1; i <= k; i++) {
    u = nearest(x + wide / 2 - px[i], X); v = nearest(y + wide / 2 - py[i], Y)
    a = (u < 0 ? -u : u) + wide / 2; b = (v < 0 ? -v : v) + wide / 2
    if (a * a + b * b <= 4) return
  }
  if (level == 0) { voxels++; print "box", "e8935a", x + shift + gap, y + gap, x + shift + wide - gap, y + wide - gap; return }
  wide /= 2
  cut(x, y, wide, level - 1); cut(x + wide, y, wide, level - 1); cut(x, y + wide, wide, level - 1); cut(x + wide, y + wide, wide, level - 1)
}
# The first k discs of the pack, cells halved so many times.
function panel(number, k0, level,   i, j, l, u, v) {
  k = k0; shift = (number - 1) * 1.08 * X; voxels = 0; gap = (level < 2) * 0.3 * point
  print "clip", shift, 0, shift + X, Y
  for (i = 1; i <= k; i++) for (j = -1; j <= 1; j++) for (l = -1; l <= 1; l++) {
    u = px[i] + j * X; v = py[i] + l * Y
    if (u > -2 && u < X + 2 && v > -2 && v < Y + 2) { x0[++t] = u + shift; y0[t] = v; print "disc", light, u + shift, v, 2 }
  }
  for (i = 0; i < m; i++) for (j = 0; j < m; j++) cut(i * X / m, j * Y / m, X / m, level)
  for (i = 1; i <= t; i++) print "disc", "4f9bcb", x0[i], y0[i], 1
  t = 0; if (k + 2 == N) for (i = k + 1; i <= N; i++) ring(red, px[i] + shift, py[i], 1, 0.9)
  print "clip"; frame(black, shift, 0, shift + X, Y, 0.8)
  words(shift + X / 2, -0.9, k " discs, " voxels " voxels")
}
END {
  m = int(X); window(-0.1, -1.6, 3.17 * X, Y + 0.1)
  panel(1, 9, 0); panel(2, 22, 1); panel(3, N - 2, 2)
}
