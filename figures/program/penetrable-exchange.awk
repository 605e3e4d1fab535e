# figures/program/penetrable-exchange.awk, after pen.awk and pack.awk: discs that may overlap; one of them, removed and thrown again, with what it alone covers, before and after.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
# The pack in a panel of its own, with the disc g at (u, v).
function panel(ox, u, v, name,   i, a, b, s, t) {
  print "clip", ox, 0, ox + X, Y
  for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) print "disc", "e8935a", ox + u + a * X, v + b * Y, 1
  for (i = 1; i <= N; i++) if (i != g) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { s = px[i] + a * X; t = py[i] + b * Y; if (s > -1 && s < X + 1 && t > -1 && t < Y + 1) print "disc", "a9d3ee", ox + s, t, 1 }
  ring(red, ox + u, v, 1, 0.9); dot(black, ox + u, v, 1.6)
  print "clip"; frame(black, ox, 0, ox + X, Y, 0.8); words(ox + X / 2, -0.6, name)
}
END {
  window(-0.05, -1.1, 2.12 * X + 0.05, Y + 0.05)
  panel(0, px[g], py[g], "before"); panel(1.12 * X, tx, ty, "after")
}
