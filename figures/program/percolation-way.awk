# figures/program/percolation-way.awk, after pen.awk and pack.awk: discs that overlap, their clusters, of which those that percolate are put together as the pairs are found,
# and the pair that closes a way round the box.
FNR > 2 { N = particle; px[N] = x; py[N] = y }
function clustered(i, c) { return cluster[i] == c }
END {
  for (i = 1; i <= N; i++) cluster[i] = i
  for (i = 1; i <= N; i++) for (j = i + 1; j <= N; j++) for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) {
    if ((px[j] + a * X - px[i]) ^ 2 + (py[j] + b * Y - py[i]) ^ 2 >= 4) continue
    wx = ox[i] + a - ox[j]; wy = oy[i] + b - oy[j]; pairs++
    from[pairs] = i; to[pairs] = j; na[pairs] = a; nb[pairs] = b
    if (cluster[i] != cluster[j]) {
      old = cluster[j]; tree[pairs] = 1
      for (k = 1; k <= N; k++) if (cluster[k] == old) { cluster[k] = cluster[i]; ox[k] += wx; oy[k] += wy }
      if (round[old]) round[cluster[i]] = 1
    } else if (wx || wy) { if (!closing) closing = pairs; round[cluster[i]] = 1 }
  }
  if (!closing) fail("no cluster of few-penetrable percolates")
  for (i = 1; i <= N; i++) if (!round[cluster[i]]) { ox[i] = oy[i] = 0 }
  # Put the percolating cluster where most of it is in the box.
  for (i = 1; i <= N; i++) if (round[cluster[i]]) { sx += ox[i]; sy += oy[i]; n_round++ }
  sx = int(sx / n_round + (sx < 0 ? -0.5 : 0.5)); sy = int(sy / n_round + (sy < 0 ? -0.5 : 0.5))
  for (i = 1; i <= N; i++) if (round[cluster[i]]) { ox[i] -= sx; oy[i] -= sy }
  for (i = 1; i <= N; i++) { qx[i] = px[i] + ox[i] * X; qy[i] = py[i] + oy[i] * Y; if (round[cluster[i]]) { if (qx[i] < x0) x0 = qx[i]; if (qx[i] > x1) x1 = qx[i]; if (qy[i] < y0) y0 = qy[i]; if (qy[i] > y1) y1 = qy[i] } }
  i = from[closing]; j = to[closing]; cx = px[j] + (ox[i] + na[closing]) * X; cy = py[j] + (oy[i] + nb[closing]) * Y
  if (cx > x1) x1 = cx; if (cx < x0) x0 = cx
  window(x0 - 1.4, (y0 < 0 ? y0 : 0) - 1.2, (x1 > X ? x1 : X) + 1.4, (y1 > Y ? y1 : Y) + 1.5)
  for (k = 1; k <= N; k++) if (!round[cluster[k]]) tiled("e4e4e4", "909090", px[k], py[k], 1)
  frame(black, 0, 0, X, Y, 1)
  for (k = 1; k <= N; k++) if (round[cluster[k]]) disc(light, blue, qx[k], qy[k], 1)
  for (k = 1; k <= N; k++) if (round[cluster[k]]) ring(blue, qx[k], qy[k], 1, 0.7)
  dash(3, 2); ring(red, cx, cy, 1, 1); dash()
  for (k = 1; k <= pairs; k++) if (tree[k] && round[cluster[from[k]]]) line(blue, qx[from[k]], qy[from[k]], qx[to[k]], qy[to[k]], 1.5)
  line(red, qx[i], qy[i], cx, cy, 1.5)
  arrow(red, qx[j], qy[j], cx, cy, 1)
  for (k = 1; k <= N; k++) if (round[cluster[k]]) dot(black, qx[k], qy[k], 1.6)
  dot(red, cx, cy, 1.8)
}
