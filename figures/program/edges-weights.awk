# figures/program/edges-weights.awk, after pen.awk and pack.awk: the centres of a pack as if its box were a window of observation, and a pair with its weight by translation,
# by Ripley's way and by minus sampling.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function deep(i,   d) { d = px[i]; if (py[i] < d) d = py[i]; if (X - px[i] < d) d = X - px[i]; if (Y - py[i] < d) d = Y - py[i]; return d }
function dots(   k) { for (k = 1; k <= N; k++) dot(k == i || k == j ? red : "707070", ox + px[k], py[k], 1.6) }
END {
  window(-0.2, -2, 3.5 * X, 1.02 * Y)
  # A centre near a wall and the farthest of those nearer than `most` to it; another one deep inside.
  most = 5.4; i = j = r = 0
  for (k = 1; k <= N; k++) if (deep(k) > 1.6 && deep(k) < 2.4 && X - px[k] < 2.4 && py[k] > 5 && py[k] < 12 && !i) i = k
  for (k = 1; k <= N; k++) { d = sqrt((px[k] - px[i]) ^ 2 + (py[k] - py[i]) ^ 2); if (k != i && d < most && d > r && px[k] < px[i] - 2 && py[k] > py[i] + 1) { r = d; j = k } }
  hx = px[j] - px[i]; hy = py[j] - py[i]
  # translation: where pairs with this separation begin
  ox = 0; print "box", "dcebf6", 0, 0, X, Y
  print "box", "a9d3ee", hx < 0 ? -hx : 0, 0, X - (hx > 0 ? hx : 0), Y - hy
  frame(black, 0, 0, X, Y, 0.9); dash(3, 2); frame(brown, -hx, -hy < 0 ? 0 : -hy, X, Y - hy, 0.9); dash()
  dots(); arrow(red, px[i], py[i], px[j], py[j], 1.2); words(X / 2, -1.3, "\\strut translation")
  # Ripley
  ox = 1.2 * X; print "box", "dcebf6", ox, 0, ox + X, Y; frame(black, ox, 0, ox + X, Y, 0.9)
  t = atan2(sqrt(r * r - (X - px[i]) ^ 2), X - px[i]); arc(blue, ox + px[i], py[i], r, t, 2 * pi - t, 2); dash(2, 2); arc(blue, ox + px[i], py[i], r, -t, t, 0.8); dash()
  dots(); arrow(red, ox + px[i], py[i], ox + px[j], py[j], 1.2); words(ox + X / 2, -1.3, "\\strut Ripley's")
  # minus sampling
  ox = 2.45 * X; print "box", "dcebf6", ox, 0, ox + X, Y; print "box", "a9d3ee", ox + r, r, ox + X - r, Y - r; frame(black, ox, 0, ox + X, Y, 0.9)
  for (k = 1; k <= N; k++) if (deep(k) >= r && (!c || (px[k] - X / 2) ^ 2 + (py[k] - Y / 2) ^ 2 < (px[c] - X / 2) ^ 2 + (py[c] - Y / 2) ^ 2)) c = k
  i = j = 0; dots(); for (k = 1; k <= N; k++) if (deep(k) >= r) dot(red, ox + px[k], py[k], 1.9)
  ring(blue, ox + px[c], py[c], r, 1.2); words(ox + X / 2, -1.3, "\\strut minus sampling")
}
