# figures/program/chords-line.awk, after pen.awk and pack.awk: a line through discs that overlap, cut at every boundary that it meets into chords of two phases.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function inside(x, y,   i) { for (i = 1; i <= N; i++) if (nearest(x - px[i], X) ^ 2 + nearest(y - py[i], Y) ^ 2 < 1) return 1; return 0 }
END {
  left = -2; right = 2.1 * X; low = 0.2 * Y; top = 0.95 * Y; window(left, low, right, top); print "clip", left, low, right, top
  for (i = 1; i <= N; i++) for (a = -1; a <= 2; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > left - 1 && u < right + 1 && v > low - 1 && v < top + 1) print "disc", "cfe5f3", u, v, 1 }
  x0 = left + 0.5; y0 = 0.4 * Y; t = 0.17; c = cos(t); s = sin(t); last = inside(x0, y0); begin = 0; len = (right - 0.5 - x0) / c
  for (k = 1; k <= 4000; k++) {
    d = len * k / 4000; now = inside(x0 + c * d, y0 + s * d)
    if (now != last || k == 4000) {
      l0 = d - len / 4000; l1 = d; for (n = 0; n < 30; n++) { f = (l0 + l1) / 2; if (inside(x0 + c * f, y0 + s * f) == last) l0 = f; else l1 = f }
      end = now == last ? d : l0
      line(last ? blue : red, x0 + c * begin, y0 + s * begin, x0 + c * end, y0 + s * end, 2); if (k < 4000 || now != last) { ends++; ex[ends] = x0 + c * l0; ey[ends] = y0 + s * l0 }
      begin = l0; last = now
    }
  }
  for (k = 1; k <= ends; k++) line(black, ex[k] - 0.22 * s, ey[k] + 0.22 * c, ex[k] + 0.22 * s, ey[k] - 0.22 * c, 1)
  print "clip"; frame(grey, left, low, right, top, 0.6)
}
