# figures/program/cells-spans.awk, after pen.awk and pack.awk: the cells of a pack for a reach of 2.7 widths, the spans around one of them, and whom a particle there has
# within reach, by the rules of chapter cells.
function floor(v) { return int(v) - (v < int(v)) }
function span(p, from, to, half,   copy, shift, y0, y1, c) {
  for (; from <= to; from = y1 + 1) {
    copy = floor(from / m); y1 = (copy + 1) * m - 1; if (y1 > to) y1 = to
    for (c = from; c <= y1; c++) seen[p, c - hy]
    c = half ? "9fcbe8" : "dcebf6"
    print "box", c, (hx + p) * w + gap, from * w + gap, (hx + p + 1) * w - gap, (y1 + 1) * w - gap
  }
}
FNR > 2 { N = particle; px[N] = x; py[N] = y }
END {
  m = 8; w = X / m; reach = 2.7 * w; gap = 1.2; hx = 2; hy = 6
  window(-1.25 * w, 0, 8.6 * w, 10.25 * w); gap = 1.1 * point
  for (i = 1; i <= N; i++) if (int(px[i] / w) == hx && int(py[i] / w) == hy) t = i
  last = reach * (1 + 1e-9)
  for (p = -3; p <= 3; p++) {
    g = (p < 0 ? -p : p) > 1 ? ((p < 0 ? -p : p) - 1) * w : 0
    h = int(sqrt(last ^ 2 - g ^ 2) / w) + 1
    if (p == 0) { span(p, hy - h, hy - 1, 0); span(p, hy, hy + h, 1) } else span(p, hy - h, hy + h, p > 0)
  }
  for (i = 1; i < m; i++) { line("bbbbbb", i * w, 0, i * w, m * w, 0.4); line("bbbbbb", 0, i * w, m * w, i * w, 0.4) }
  frame(black, 0, 0, X, Y, 1)
  for (i = 1; i <= N; i++) for (a = -1; a <= 0; a++) for (b = 0; b <= 1; b++) {
    u = px[i] + a * X; v = py[i] + b * Y; d = sqrt((u - px[t]) ^ 2 + (v - py[t]) ^ 2)
    if ((a || b) && !((floor(u / w) - hx, floor(v / w) - hy) in seen)) continue
    print "disc", (i == t && !a && !b ? red : d < reach ? blue : a || b ? "b0b0b0" : "909090"), u, v, 0.75
  }
  ring(red, px[t], py[t], reach, 1); frame(red, hx * w, hy * w, (hx + 1) * w, (hy + 1) * w, 1.2)
}
