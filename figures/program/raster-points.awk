# figures/program/raster-points.awk, after pen.awk and pack.awk: discs that overlap, the points of a raster in them and in the matrix, and those from which a shift leads to
# another point in the discs.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function inside(x, y,   i) { for (i = 1; i <= N; i++) if (nearest(x - px[i], X) ^ 2 + nearest(y - py[i], Y) ^ 2 < 1) return 1; return 0 }
END {
  m = 20; w = X / m; sx = 3; sy = 1
  for (a = 0; a < m; a++) for (b = 0; b < m; b++) { I[a, b] = inside((a + 0.5) * w, (b + 0.5) * w); sum += I[a, b] }
  window(-0.05, -0.05, X + 0.05, Y + 0.05); print "clip", 0, 0, X, Y
  for (i = 1; i <= N; i++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[i] + a * X; v = py[i] + b * Y; if (u > -1 && u < X + 1 && v > -1 && v < Y + 1) print "disc", "cfe5f3", u, v, 1 }
  for (k = 0; k < 3; k++) for (a = 0; a < m; a++) for (b = 0; b < m; b++) {
    what = I[a, b] ? (I[(a + sx) % m, (b + sy) % m] ? 2 : 1) : 0; if (what != k) continue
    counted += k == 2; dot(k == 0 ? "999999" : k == 1 ? blue : red, (a + 0.5) * w, (b + 0.5) * w, k ? 2 : 1.2)
    if (k == 2 && a < m - sx && b < m - sy && a % 6 == 2 && b % 5 == 2) { arrows++; fx[arrows] = (a + 0.5) * w; fy[arrows] = (b + 0.5) * w }
  }
  for (k = 1; k <= arrows; k++) arrow(black, fx[k], fy[k], fx[k] + sx * w, fy[k] + sy * w, 1)
  print "clip"; frame(black, 0, 0, X, Y, 0.8)
}
