# figures/program/motion-contact.awk, after pen.awk and pack.awk: three pairs of a pack, made smaller, which fly and grow: where they meet, or are nearest, and f over time.
# Velocities are the ways of a few rounds of moves, made longer.
FNR > 2 { px[file, particle] = x; py[file, particle] = y; N = particle }
function vx(i) { return 2.5 * nearest(px[2, i] - px[1, i], X) }
function vy(i) { return 2.5 * nearest(py[2, i] - py[1, i], Y) }
function f(t) { return (dx + ux * t) ^ 2 + (dy + uy * t) ^ 2 - 4 * (s + g * t) ^ 2 }
# The pair i, j in a column of its own, over its f, which is drawn to the scale `high`.
function pair(i, j, ox, oy, name, turn, high,   A, B, C, Q, t, k, n, row, a, w, x0, y0) {
  dx = nearest(px[1, j] - px[1, i], X); dy = nearest(py[1, j] - py[1, i], Y); ux = vx(j) - vx(i); uy = vy(j) - vy(i)
  A = ux * ux + uy * uy - 4 * g * g; B = dx * ux + dy * uy - 4 * s * g; C = dx * dx + dy * dy - 4 * s * s; Q = B * B - A * C
  t = B < 0 ? (Q < 0 ? -B / A : C / (-B + sqrt(Q))) : (B + sqrt(Q)) / -A
  a = s + g * t; x0 = ox - dx / 2; y0 = oy - dy / 2
  dash(2, 2); ring(blue, x0 + vx(i) * t, y0 + vy(i) * t, a, 0.8); ring(brown, x0 + dx + vx(j) * t, y0 + dy + vy(j) * t, a, 0.8); dash()
  disc(light, blue, x0, y0, s); disc(cream, brown, x0 + dx, y0 + dy, s)
  arrow(blue, x0, y0, x0 + vx(i) * t, y0 + vy(i) * t, 1.2); arrow(brown, x0 + dx, y0 + dy, x0 + dx + vx(j) * t, y0 + dy + vy(j) * t, 1.2)
  w = 5; row = "curve" OFS black OFS 1.1; x0 = ox - w / 2; y0 = -5.2
  line(grey, x0, y0, x0 + w, y0, 0.5); line(grey, x0, y0 - 0.5, x0, y0 + 2.2, 0.5)
  for (k = 0; k <= 30; k++) { n = 1.25 * t * k / 30; row = row OFS x0 + w * k / 30 / 1.1 OFS y0 + high * f(n) }
  print row; dot(red, x0 + w / 1.1 * 0.8, y0 + high * f(t), 2.2)
  words(x0 + w, y0 - 0.45, "$\\tau$"); words(x0 - 0.4, y0 + 1.8, "$f$"); words(ox, 3.6, name)
}
END {
  s = 0.5; g = 0.35
  window(-3.2, -6, 17.2, 4)
  pair(3, 35, 0, 0, "approaching, a root", 0, 0.19); pair(1, 15, 7, 0, "approaching, no root", 0, 0.22); pair(6, 29, 14, 0, "receding, overtaken", 0, 0.5)
}
