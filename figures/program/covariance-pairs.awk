# figures/program/covariance-pairs.awk, after pen.awk and pack.awk: discs that overlap, a point of their exposed boundary with its normal, and what of the boundary is nearer than
# r to it, with some normals there. Where arcs end is found by halving.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function exposed(i, t,   j, u, v) {
  u = px[i] + cos(t); v = py[i] + sin(t)
  for (j = 1; j <= N; j++) if (j != i && nearest(u - px[j], X) ^ 2 + nearest(v - py[j], Y) ^ 2 < 1) return 0
  return 1
}
# Where exposed(i) changes between t0 and t1; of the copy at (u, v), if `near`, where the circle cuts it as well.
function status(i, t) { return exposed(i, t) * (1 + ((cu + cos(t) - qx) ^ 2 + (cv + sin(t) - qy) ^ 2 < reach * reach)) }
function root(i, t0, t1,   k, t, s) { s = status(i, t0); for (k = 0; k < 26; k++) { t = (t0 + t1) / 2; if (status(i, t) == s) t0 = t; else t1 = t } return t0 }
END {
  reach = 2.2
  for (k = 0; k < 360; k++) { t = k * pi / 180; if (exposed(chosen, t) && exposed(chosen, t + 0.25) && exposed(chosen, t - 0.25) && !found) { found = 1; qt = t } }
  if (!found) fail("the disc has no free boundary")
  qx = px[chosen] + cos(qt); qy = py[chosen] + sin(qt); half = 3.1; high = 2.5
  window(qx - half, qy - high, qx + half, qy + high); print "clip", qx - half, qy - high, qx + half, qy + high
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > qx - half - 1 && u < qx + half + 1 && v > qy - high - 1 && v < qy + high + 1) print "disc", "dcebf6", u, v, 1 }
  dash(3, 2); ring(grey, qx, qy, reach, 0.9); dash()
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    cu = px[i] + a * X; cv = py[i] + b * Y; if (!(cu > qx - half - 1 && cu < qx + half + 1 && cv > qy - high - 1 && cv < qy + high + 1)) continue
    n_roots = 0; last = status(i, 0.001)
    for (k = 1; k <= 180; k++) { t = 0.001 + k * pi / 90; s = status(i, t); if (s != last) { cut_at[++n_roots] = root(i, t - pi / 90, t); what[n_roots] = s; last = s } }
    if (!n_roots) { n_roots = 1; cut_at[1] = 0; what[1] = last }
    cut_at[n_roots + 1] = cut_at[1] + 2 * pi
    for (k = 1; k <= n_roots; k++) if (what[k]) {
      arc(what[k] == 2 ? red : blue, cu, cv, 1, cut_at[k], cut_at[k + 1], what[k] == 2 ? 2 : 1.1)
      t = (cut_at[k] + cut_at[k + 1]) / 2
      if (what[k] == 2 && i != chosen && cut_at[k + 1] - cut_at[k] > 0.6) arrow(black, cu + cos(t), cv + sin(t), cu + 1.5 * cos(t), cv + 1.5 * sin(t), 0.9)
    }
  }
  arrow(black, qx, qy, qx + 0.6 * cos(qt), qy + 0.6 * sin(qt), 1.2); dot(black, qx, qy, 2.2)
  words(qx - 0.28 * cos(qt), qy - 0.28 * sin(qt) + 0.1, "$\\mathbf x$"); line(grey, qx, qy, qx + reach * 0.6, qy - reach * 0.8, 0.7); words(qx + 0.85, qy - 0.85, "$r$")
  print "clip"; frame(grey, qx - half, qy - high, qx + half, qy + high, 0.6)
}
