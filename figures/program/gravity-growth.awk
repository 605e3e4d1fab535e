# figures/program/gravity-growth.awk, after pen.awk and pack.awk: packs by gravity from the same points, grown by three factors, to one scale, that of the first radius.
FNR > 2 { split(FILENAME, piece, /[@]|\.xyz/); F[file] = piece[2]; px[file, particle] = (x - X / 2) * F[file]; py[file, particle] = (y - Y / 2) * F[file]; N = particle }
END {
  for (k = 1; k <= 3; k++) { rim = 0; for (i = 1; i <= N; i++) { d = sqrt(px[k, i] ^ 2 + py[k, i] ^ 2) + F[k]; if (d > rim) rim = d }; R[k] = rim }
  window(-R[1] - 0.2, -R[3] - 2.6, R[1] + 2 * R[2] + 2 * R[3] + 3.2, R[3] + 0.2)
  ox = 0
  for (k = 1; k <= 3; k++) {
    if (k > 1) ox += R[k - 1] + R[k] + 1.5
    for (pass = 0; pass < 6; pass++) for (i = 1; i <= N; i++) {
      sort = i == 1 ? 2 : marked(i); if (sort != pass % 3) continue
      print "disc", (pass < 3 ? (sort == 2 ? red : sort ? brown : blue) : sort == 2 ? red : sort ? cream : light), ox + px[k, i], py[k, i], pass < 3 ? F[k] : F[k] - 0.7 * point
    }
    ring(grey, ox, 0, R[k], 0.6); words(ox, -R[3] - 1.6, "$" F[k] "\\,r_0$")
  }
}
# The same few in all packs: those that are farthest out at first.
function marked(i) { return px[1, i] ^ 2 + py[1, i] ^ 2 > (0.74 * R[1]) ^ 2 }
