# figures/program/sections-plane.awk, after pen.awk and pack.awk: the spheres of a pack that a plane meets, seen along the plane, and the discs that it shows.
FNR > 2 { N = particle; px[N] = x; py[N] = y; pz[N] = z; pr[N] = r }
END {
  h = Z / 2; far = 1.3 * X; window(-1.1, -1.4, far + X + 0.1, Y + 0.1)
  # seen along y: those in front last
  for (k = 1; k <= N; k++) { d[k] = pz[k] - h; met[k] = d[k] * d[k] < pr[k] ^ 2 }
  for (step = 24; step >= 0; step--) for (k = 1; k <= N; k++) if (met[k] && int(py[k] / Y * 25) == step) disc(pr[k] > 0.8 ? cream : light, pr[k] > 0.8 ? brown : blue, px[k], Y / 2 + d[k], pr[k])
  line(red, -1, Y / 2, X + 1, Y / 2, 1.2)
  for (k = 1; k <= N; k++) if (met[k]) { c = sqrt(pr[k] ^ 2 - d[k] ^ 2); line(pr[k] > 0.8 ? brown : blue, px[k] - c, Y / 2, px[k] + c, Y / 2, 2.4) }
  frame(black, far, 0, far + X, Y, 0.8); print "clip", far, 0, far + X, Y
  for (k = 1; k <= N; k++) if (d[k] * d[k] < pr[k] ^ 2) {
    c = sqrt(pr[k] ^ 2 - d[k] ^ 2)
    for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) { u = px[k] + a * X; v = py[k] + b * Y; if (u > -1 && u < X + 1 && v > -1 && v < Y + 1) { disc(pr[k] > 0.8 ? cream : light, pr[k] > 0.8 ? brown : blue, far + u, v, c); dash(1, 1.5); ring("b0b0b0", far + u, v, pr[k], 0.5); dash() } }
  }
  print "clip"
  words(X / 2, -0.9, "the plane from the side"); words(far + X / 2, -0.9, "the section")
}
