# figures/program/chain-path.awk, after pen.awk and pack.awk: a straight chain of events along x in a pack, from the disc `start` over the length `length_of`: where each of
# those that move was, and where it stops and lifts the next.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
END {
  i = start; left = length_of
  for (k = 1; left > 0; k++) {
    way = left; next_one = 0
    for (j = 1; j <= N; j++) {
      if (j == i) continue
      v = nearest(py[j] - py[i], Y); if (v >= 2 || v <= -2) continue
      for (u = nearest(px[j] - px[i], X); u <= X; u += X) if (u > 0) { s = u - sqrt(4 - v * v); if (s < way) { way = s < 0 ? 0 : s; next_one = j } }
    }
    x0[k] = px[i]; y0[k] = py[i]; x1[k] = px[i] + way; moved[i] = 1; px[i] += way; left -= way; i = next_one; moves = k
    if (!i) break
  }
  low = y0[1] - 3.9; high = y0[1] + 4.2
  if (x1[moves] > X) fail("the chain leaves the box")
  window(0, low, X, high); print "clip", 0, low, X, high
  for (j = 1; j <= N; j++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    u = px[j] + a * X; v = py[j] + b * Y
    if (!moved[j] && u > -1 && u < X + 1 && v > low - 1 && v < high + 1) disc("ececec", "909090", u, v, 1)
  }
  for (k = 1; k <= moves; k++) disc(light, blue, x1[k], y0[k], 1)
  dash(2, 2); for (k = 1; k <= moves; k++) ring(brown, x0[k], y0[k], 1, 0.8); dash()
  for (k = 1; k < moves; k++) { dot(black, (x1[k] + x0[k + 1]) / 2, (y0[k] + y0[k + 1]) / 2, 1.5) }
  for (k = 1; k <= moves; k++) { dot(brown, x0[k], y0[k], 1.4); arrow(red, x0[k], y0[k], x1[k], y0[k], 1.3) }
  for (k = 1; k <= moves; k++) words(x1[k], y0[k] - 0.52, k)
  print "clip"; frame(grey, 0, low, X, high, 0.6)
}
