# figures/program/pores-union.awk, after pen.awk and pack.awk: the discs of a pack, made larger by r, for three r; what is left is where a disc of radius r fits.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function panel(ox, r,   i, a, b, u, v, t) {
  print "clip", ox, 0, ox + X, Y; print "box", "f3c7a6", ox, 0, ox + X, Y
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > -1 - r && u < X + 1 + r && v > -1 - r && v < Y + 1 + r) { t++; qx[t] = ox + u; qy[t] = v } }
  if (r) for (i = 1; i <= t; i++) print "disc", light, qx[i], qy[i], 1 + r
  for (i = 1; i <= t; i++) print "disc", "4f9bcb", qx[i], qy[i], 1
  print "clip"; frame(black, ox, 0, ox + X, Y, 0.8); words(ox + X / 2, -0.8, "$r=" r "$")
}
END { window(-0.1, -1.5, 3.17 * X, Y + 0.1); panel(0, 0); panel(1.08 * X, 0.3); panel(2.16 * X, 0.6) }
