# figures/program/shake-trial.awk, after pen.awk and pack.awk: one disc among its neighbours, the window of its centre, what of that the neighbours leave free, some trials,
# and a free path.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
END {
  c = chosen; W = 0.75; left = -3.2; right = 3.2; low = -2.4; high = 2.4
  window(left, low, right, high); print "clip", left, low, right, high
  print "disc", "a8dcc6", 0, 0, W
  for (i = 1; i <= N; i++) { u[i] = nearest(px[i] - px[c], X); v[i] = nearest(py[i] - py[c], Y); if (i != c) print "disc", "e9e9e9", u[i], v[i], 2 }
  for (i = 1; i <= N; i++) if (i != c) disc(light, blue, u[i], v[i], 1)
  dash(3, 2); ring(black, 0, 0, 1, 0.9); dash(); ring(green, 0, 0, W, 1.1)
  # trials: points of the window by a simple rule
  for (k = 0; k < 14; k++) {
    r = W * sqrt((k + 0.5) / 14); t = 2.39996 * k + 1; a = r * cos(t); b = r * sin(t); bad = 0
    for (i = 1; i <= N; i++) if (i != c && (u[i] - a) ^ 2 + (v[i] - b) ^ 2 < 4) bad = 1
    dot(bad ? red : green, a, b, 1.7)
  }
  ex = cos(way * pi / 180); ey = sin(way * pi / 180); s = 99
  for (i = 1; i <= N; i++) { if (i == c) continue; b = u[i] * ex + v[i] * ey; q = u[i] ^ 2 + v[i] ^ 2 - 4; if (b > 0 && b * b >= q && q / (b + sqrt(b * b - q)) < s) s = q / (b + sqrt(b * b - q)) }
  dash(1, 1.5); ring(brown, s * ex, s * ey, 1, 0.9); dash(); arrow(brown, 0, 0, s * ex, s * ey, 1.3); dot(black, 0, 0, 1.9)
  print "clip"; frame(grey, left, low, right, high, 0.6)
}
