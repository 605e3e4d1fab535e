# figures/program/order-frame.awk, after pen.awk and pack.awk: the frame of a jammed pack and its rattlers: particles with fewer than three contacts are taken away until there
# are none.
FNR > 2 { N = particle; px[N] = x; py[N] = y; pr[N] = r }
END {
  for (i = 1; i <= N; i++) for (j = 1; j < i; j++) {
    u = nearest(px[i] - px[j], X); v = nearest(py[i] - py[j], Y)
    if (sqrt(u * u + v * v) < (pr[i] + pr[j]) * (1 + 1e-4)) { contacts++; a[contacts] = i; b[contacts] = j; held[i]++; held[j]++ }
  }
  do {
    again = 0
    for (i = 1; i <= N; i++) if (!loose[i] && held[i] < 3) {
      loose[i] = again = 1
      for (k = 1; k <= contacts; k++) if (!gone[k] && (a[k] == i || b[k] == i)) { gone[k] = 1; held[a[k]]--; held[b[k]]-- }
    }
  } while (again)
  for (i = 1; i <= N; i++) frame_size += !loose[i]
  for (k = 1; k <= contacts; k++) left += !gone[k]
  if (left != 2 * (frame_size - 1) + 1) fail("the frame of few-jammed is not isostatic")
  window(-0.05, -0.05, X + 0.05, Y + 0.05); print "clip", 0, 0, X, Y
  for (pass = 0; pass < 3; pass++) for (i = 1; i <= N; i++) for (c = -1; c <= 1; c++) for (d = -1; d <= 1; d++) {
    u = px[i] + c * X; v = py[i] + d * Y; if (u < -pr[i] || u > X + pr[i] || v < -pr[i] || v > Y + pr[i]) continue
    if (pass == 0) print "disc", blue, u, v, pr[i]
    else if (loose[i] == pass - 1) print "disc", (pass == 1 ? light : cream), u, v, pr[i] - 0.7 * point
  }
  for (k = 1; k <= contacts; k++) if (!gone[k]) {
    u = nearest(px[b[k]] - px[a[k]], X); v = nearest(py[b[k]] - py[a[k]], Y)
    line(black, px[a[k]], py[a[k]], px[a[k]] + u, py[a[k]] + v, 1.3)
    if (px[a[k]] + u < 0 || px[a[k]] + u > X || py[a[k]] + v < 0 || py[a[k]] + v > Y) line(black, px[b[k]], py[b[k]], px[b[k]] - u, py[b[k]] - v, 1.3)
  }
  print "clip"; frame(grey, 0, 0, X, Y, 0.8)
}
