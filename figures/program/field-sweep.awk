# figures/program/field-sweep.awk, after pen.awk and pack.awk: two packs of the program, a sweep apart: the discs by rank as they stood before, what each push of
# the sweep did, and the discs after it. The pushes are done here once more, by their equation, and must end at the second pack.
FNR > 2 { px[file, particle] = x - X / 2; py[file, particle] = y - Y / 2; N = particle }
END {
  for (i = 1; i <= N; i++) { u[i] = px[1, i]; v[i] = py[1, i]; key[i] = u[i] ^ 2 + v[i] ^ 2 }
  for (i = 1; i <= N; i++) { rank[i] = 1; for (j = 1; j <= N; j++) if (key[j] < key[i] || key[j] == key[i] && j < i) rank[i]++; who[rank[i]] = i }
  for (k = 1; k <= N; k++) for (l = k + 1; l <= N; l++) {
    i = who[k]; j = who[l]; dx = u[j] - u[i]; dy = v[j] - v[i]; r = sqrt(dx * dx + dy * dy)
    if (r >= 2) continue
    pushes++; pushed[j]++; a[pushes] = u[j]; b[pushes] = v[j]
    u[j] = u[i] + 2 / r * dx; v[j] = v[i] + 2 / r * dy; c[pushes] = u[j]; d[pushes] = v[j]
  }
  for (i = 1; i <= N; i++) if ((u[i] - px[2, i]) ^ 2 + (v[i] - py[2, i]) ^ 2 > 1e-16) fail("the sweep of few-gravity is not that of the equation")
  apart = 13.5
  window(-6.2, -5.6, 19.7, 7.1)
  for (i = 1; i <= N; i++) disc(pushed[i] ? cream : "e8e8e8", pushed[i] ? brown : grey, px[1, i], py[1, i], 1)
  for (i = 1; i <= N; i++) for (j = 1; j < i; j++) if ((px[1, i] - px[1, j]) ^ 2 + (py[1, i] - py[1, j]) ^ 2 < 3.8) ring(pushed[j] ? brown : grey, px[1, j], py[1, j], 1, 0.7)
  for (k = 1; k <= pushes; k++) arrow(red, a[k], b[k], c[k], d[k], 1.4)
  for (i = 1; i <= N; i++) words(px[1, i] - (pushed[i] ? 0.5 * px[1, i] / sqrt(key[i]) : 0), py[1, i] - (pushed[i] ? 0.5 * py[1, i] / sqrt(key[i]) : 0), rank[i])
  for (i = 1; i <= N; i++) disc(pushed[i] ? cream : "e8e8e8", pushed[i] ? brown : grey, px[2, i] + apart, py[2, i], 1)
  for (i = 1; i <= N; i++) words(px[2, i] + apart, py[2, i], rank[i])
  words(0, -5.2, "before, with the " pushes " pushes of the sweep"); words(apart, -5.2, "after the sweep")
}
