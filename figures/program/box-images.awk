# figures/program/box-images.awk, after pen.awk and pack.awk: the box with what it repeats, a disc and the nearest images of three others.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
END {
  out = 0.42; window(-out * X, -out * Y, (1 + out) * X, (1 + out) * Y); print "clip", -out * X, -out * Y, (1 + out) * X, (1 + out) * Y
  for (pass = 0; pass < 4; pass++) for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    u = px[i] + a * X; v = py[i] + b * Y; own = !a && !b
    if (own != pass % 2 || u < -out * X - 1 || u > (1 + out) * X + 1 || v < -out * Y - 1 || v > (1 + out) * Y + 1) continue
    print "disc", (pass < 2 ? (own ? blue : "b0b0b0") : own ? light : "f0f0f0"), u, v, pass < 2 ? 1 : 1 - 0.7 * point
  }
  frame(black, 0, 0, X, Y, 1)
  dash(3, 2); ring(red, px[c], py[c], X / 2, 1); dash()
  many = split(others, other, " ")
  for (k = 1; k <= many; k++) {
    j = other[k]; u = nearest(px[j] - px[c], X); v = nearest(py[j] - py[c], Y)
    arrow(red, px[c], py[c], px[c] + u, py[c] + v, 1.3); dot(black, px[c] + u, py[c] + v, 1.6)
    if ((px[c] + u - px[j]) ^ 2 + (py[c] + v - py[j]) ^ 2 > 1e-9) { dot(black, px[j], py[j], 1.6); dash(1, 1.5); line(grey, px[c], py[c], px[j], py[j], 0.8); dash() }
  }
  dot(red, px[c], py[c], 2.2); print "clip"
}
