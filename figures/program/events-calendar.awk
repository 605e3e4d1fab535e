# figures/program/events-calendar.awk, after pen.awk and pack.awk: the first meetings of discs that fly and grow, as in motion-contact.awk, in the slices of a calendar.
FNR > 2 { px[file, particle] = x; py[file, particle] = y; N = particle }
function vx(i) { return 2.5 * nearest(px[2, i] - px[1, i], X) }
function vy(i) { return 2.5 * nearest(py[2, i] - py[1, i], Y) }
function meeting(i, j,   dx, dy, ux, uy, A, B, C, Q) {
  dx = nearest(px[1, j] - px[1, i], X); dy = nearest(py[1, j] - py[1, i], Y); ux = vx(j) - vx(i); uy = vy(j) - vy(i)
  A = ux * ux + uy * uy - 4 * g * g; B = dx * ux + dy * uy - 4 * s * g; C = dx * dx + dy * dy - 4 * s * s; Q = B * B - A * C
  return B < 0 ? (Q < 0 ? 1e9 : C / (-B + sqrt(Q))) : A < 0 ? (B + sqrt(Q)) / -A : 1e9
}
function stack(x, y, which, i, twice,   h) {
  h = y + 1.28 * height[which]++
  print "path", twice ? cream : light, twice ? brown : blue, 0.6, x + 0.02, h, x + 0.98, h, x + 0.98, h + 1.2, x + 0.02, h + 1.2
  print "words", x + 0.5, h + 0.6, "\\scriptsize " i
}
END {
  s = 0.5; g = 0.1; N = 24
  for (i = 1; i <= N; i++) { time[i] = 1e9; for (j = 1; j <= N; j++) if (j != i) { t = meeting(i, j); if (t < time[i]) { time[i] = t; partner[i] = j } } if (time[i] < 1e9) { sum += time[i]; count++ } if (i == 1 || time[i] < start) start = time[i] }
  for (slices = 64; slices < 2 * N; ) slices *= 2
  rate = slices / (2 * (sum / count - start))
  window(-0.6, -1, 35.6, 9.2)
  for (r = 0; r < 2; r++) for (k = 0; k < 32; k++) {
    line(grey, k, 5.4 * (1 - r), k + 1, 5.4 * (1 - r), 0.6); line(grey, k, 5.4 * (1 - r), k, 5.4 * (1 - r) + 0.3, 0.6)
    if (k % 8 == 0) words(k + 0.5, 5.4 * (1 - r) - 0.6, 32 * r + k)
  }
  line(grey, 32, 5.4, 32, 5.7, 0.6); line(grey, 32, 0, 32, 0.3, 0.6)
  for (i = N; i >= 1; i--) {
    k = int((time[i] - start) * rate); c = partner[partner[i]] == i
    if (time[i] < 1e9) stack(k < slices ? k % 32 : 33.6, k < 32 ? 5.4 : 0, k < slices ? k : "beyond", i, c)
  }
  line(grey, 33.1, 0, 35.1, 0, 0.6); words(34.1, -0.6, "beyond"); words(0.9, 8.6, "heap")
}
