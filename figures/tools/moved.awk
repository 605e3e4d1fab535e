# figures/tools/moved.awk, after colour.awk and pack.awk: discs of two files of one pack, where they are, by the way that they have gone, with
# outlines and lines from where they were; with their images over the sides.
FNR > 2 && file == 1 { x0[particle] = x; y0[particle] = y; next }
FNR > 2 {
  dx = x - x0[particle]; dx -= X * int(dx / X + (dx < 0 ? -0.5 : 0.5)); dy = y - y0[particle]; dy -= Y * int(dy / Y + (dy < 0 ? -0.5 : 0.5))
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    u = x + i * X; v = y + j * Y
    if (u > -1.6 * r && u < X + 1.6 * r && v > -1.6 * r && v < Y + 1.6 * r) {
      n++; a[n] = u; b[n] = v; da[n] = dx; db[n] = dy; way[n] = sqrt(dx * dx + dy * dy); R[n] = r
      if (way[n] > most) most = way[n]
    }
  }
}
END {
  most = int(5 * most + 1) / 5; palette = "0 f4f8fb 0.5 8cc0e0 1 0072b2"
  print "window", 0, 0, 1.19 * X, Y; print "clip", 0, 0, X, Y
  for (i = 1; i <= n; i++) print "disc", shade(palette, way[i] / most), a[i], b[i], R[i]
  for (i = 1; i <= n; i++) print "ring", "444444", a[i] - da[i], b[i] - db[i], R[i], 0.7
  for (i = 1; i <= n; i++) print "line", "d55e00", a[i] - da[i], b[i] - db[i], a[i], b[i], 1.5
  for (i = 1; i <= n; i++) print "disc", "d55e00", a[i], b[i], 0.07
  frame("777777", 0, 0, X, Y, 1.2); print "clip"
  bar(palette, 1.03 * X, 0.25 * Y, 1.05 * X, 0.75 * Y, "y")
  for (t = 0; t < most + 0.1; t += 0.2) print "words", 1.06 * X, (0.25 + 0.5 * t / most) * Y, sprintf("%.1f", t), "left"
  print "words", 1.15 * X, 0.5 * Y, "\\rotatebox{90}{way gone, in radii}"
}
