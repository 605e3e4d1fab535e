# figures/program/indicator-blocks.awk, after pen.awk and pack.awk: a box of discs as blocks that are inside a disc, outside of all, or undecided and halved.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
# Judge the block from (x, y), so wide; undecided, it is halved so many times more.
function judge(x, y, wide, more,   i, a, b, u, v, near, cut) {
  for (i = 1; i <= N; i++) {
    a = nearest(x + wide / 2 - px[i], X); if (a < 0) a = -a; b = nearest(y + wide / 2 - py[i], Y); if (b < 0) b = -b
    if ((a + wide / 2) ^ 2 + (b + wide / 2) ^ 2 < 1) { put("a9d3ee", x, y, wide); return }
    u = a > wide / 2 ? a - wide / 2 : 0; v = b > wide / 2 ? b - wide / 2 : 0
    if (u * u + v * v < 1) cut = 1
  }
  if (!cut) { put("eeeeee", x, y, wide); return }
  if (!more) { put("e8935a", x, y, wide); return }
  wide /= 2; more--
  judge(x, y, wide, more); judge(x + wide, y, wide, more); judge(x, y + wide, wide, more); judge(x + wide, y + wide, wide, more)
}
function put(c, x, y, wide) { count[c]++; list[c, count[c]] = x OFS y OFS wide }
END {
  window(-0.05, -0.05, X + 0.05, Y + 0.05); g = 0.28 * point
  for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) judge(i * X / 4, j * Y / 4, X / 4, 3)
  many = split("eeeeee a9d3ee e8935a", colour, " ")
  for (c = 1; c <= many; c++) for (k = 1; k <= count[colour[c]]; k++) { split(list[colour[c], k], b, OFS); print "box", colour[c], b[1] + g, b[2] + g, b[1] + b[3] - g, b[2] + b[3] - g }
  print "clip", 0, 0, X, Y
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b0 = -1; b0 <= 1; b0++) { u = px[i] + a * X; v = py[i] + b0 * Y; if (u > -1 && u < X + 1 && v > -1 && v < Y + 1) { ring(blue, u, v, 1, 0.7); dot(blue, u, v, 1.2) } }
  print "clip"; frame(black, 0, 0, X, Y, 0.8)
}
