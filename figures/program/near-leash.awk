# figures/program/near-leash.awk, after pen.awk and pack.awk: discs of two packs, before and after some rounds of moves: homes where they were, leashes about them, the
# neighbours of one of them; those farther from home than their leash are taut.
FNR > 2 { px[file, particle] = x; py[file, particle] = y; N = particle }
# A piece of the box about disc c, its image nearest to it.
function put(f, i) { u = nearest(px[f, i] - px[1, c], X); v = nearest(py[f, i] - py[1, c], Y) }
END {
  c = chosen; leash = 0.45; half = 5.4
  window(-half, -0.78 * half, half, 0.78 * half); print "clip", -half, -0.78 * half, half, 0.78 * half
  for (i = 1; i <= N; i++) {
    put(1, i); hx[i] = u; hy[i] = v; x1[i] = u + nearest(px[2, i] - px[1, i], X); y1[i] = v + nearest(py[2, i] - py[1, i], Y)
    far[i] = sqrt((x1[i] - u) ^ 2 + (y1[i] - v) ^ 2); near[i] = i != c && sqrt(u * u + v * v) < 2 * (1 + leash)
  }
  for (i = 1; i <= N; i++) disc(i == c ? "9fcbe8" : near[i] ? light : "ececec", i == c || near[i] ? blue : "909090", x1[i], y1[i], 1)
  for (i = 1; i <= N; i++) { if (i == c) continue; if (near[i]) line(blue, 0, 0, hx[i], hy[i], 1.1) }
  dash(2, 2); for (i = 1; i <= N; i++) if (i == c || near[i]) ring(far[i] > leash ? red : blue, hx[i], hy[i], leash, 0.8); dash()
  for (i = 1; i <= N; i++) if (i == c || near[i]) { line(far[i] > leash ? red : black, hx[i], hy[i], x1[i], y1[i], 1.1); dot(black, hx[i], hy[i], 1.6); dot(far[i] > leash ? red : black, x1[i], y1[i], 1.1) }
  dash(4, 2); ring(grey, 0, 0, 1 + leash, 0.8); dash()
  print "clip"; frame(grey, -half, -0.78 * half, half, 0.78 * half, 0.6)
}
