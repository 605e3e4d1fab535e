# figures/program/threepoint-arms.awk, after pen.awk and pack.awk: samples of three points among discs that overlap: a point with two arms, and the points at all lengths of
# each that are in the discs.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function inside(x, y,   i) { for (i = 1; i <= N; i++) if (nearest(x - px[i], X) ^ 2 + nearest(y - py[i], Y) ^ 2 < 1) return 1; return 0 }
# The points of an arm from (x, y) along t, and their bits.
function arm(x, y, t, c, name,   k, u, v, bits) {
  line(grey, x, y, x + 8.5 * step * cos(t), y + 8.5 * step * sin(t), 0.6)
  for (k = 1; k <= 8; k++) {
    u = x + k * step * cos(t); v = y + k * step * sin(t); dot(c, u, v, 2.2); if (!inside(u, v)) dot("ffffff", u, v, 1.4)
    bits = bits inside(u, v)
  }
  words(x + 9.6 * step * cos(t), y + 9.6 * step * sin(t), name)
  return bits
}
END {
  step = 0.34; window(-0.05, -0.05, 1.75 * X, Y + 0.05); print "clip", 0, 0, X, Y
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > -1 && u < X + 1 && v > -1 && v < Y + 1) print "disc", "cfe5f3", u, v, 1 }
  print "clip"; frame(black, 0, 0, X, Y, 0.8)
  split(samples, sample, " ")
  for (k = 0; (3 * k + 1) in sample; k++) {
    u = sample[3 * k + 1]; v = sample[3 * k + 2]; t = sample[3 * k + 3]
    first_arm = arm(u, v, t, blue, "$A$"); second_arm = arm(u, v, t + 1.2, red, "$C$")
    dot(black, u, v, 2.6); if (!inside(u, v)) dot("ffffff", u, v, 1.7)
    words(u - 0.35, v - 0.1, k + 1)
    y = Y - 2 - 2.8 * k; words(1.08 * X, y + 0.6, (k + 1) ": $A=" first_arm "$", "left"); words(1.08 * X + 0.35, y - 0.3, "$C=" second_arm "$", "left")
  }
}
