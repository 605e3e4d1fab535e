# figures/program/window-share.awk, after pen.awk and pack.awk: the box of a pack as a window, and a circle about a centre near its corner: what is in the window, what is beyond
# one wall, and what is beyond both.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
END {
  u = px[c]; v = py[c]; low_x = u - reach - 0.9; low_y = v - reach - 0.6; top_x = u + reach + 0.6; top_y = v + reach + 0.6
  window(low_x, low_y, top_x, top_y); print "clip", low_x, low_y, top_x, top_y
  print "box", "eaf3fa", low_x, low_y, X, Y
  for (k = 1; k <= N; k++) if (px[k] > low_x && py[k] > low_y) dot(k == c ? red : "808080", px[k], py[k], k == c ? 2.4 : 1.8)
  line(black, X, low_y, X, Y, 1.2); line(black, low_x, Y, X, Y, 1.2); dash(3, 2); line(grey, X, Y, X, top_y, 0.7); line(grey, X, Y, top_x, Y, 0.7); dash()
  # the angles where the circle crosses the walls
  p = atan2(sqrt(reach ^ 2 - (X - u) ^ 2), X - u); q = atan2(Y - v, sqrt(reach ^ 2 - (Y - v) ^ 2))
  arc(blue, u, v, reach, pi - q, 2 * pi - p, 2); arc(red, u, v, reach, -p, q, 2); arc(brown, u, v, reach, p, pi - q, 2); arc(black, u, v, reach, q, p, 3.2)
  line(red, u, v, X, v, 0.8); line(brown, u, v, u, Y, 0.8); words((u + X) / 2, v - 0.35, "$ar$"); words(u - 0.4, (v + Y) / 2, "$br$")
  print "clip"
}
