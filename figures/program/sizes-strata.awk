# figures/program/sizes-strata.awk, after pen.awk and pack.awk: Lorenz's curve of a power law, cut into strata of equal number, and the radii that a pack has of them.
FNR > 2 { N = particle; a[N] = r }
function E(s, t) { return (exp(s * t) - 1) / s }
END {
  for (i = 1; i <= N; i++) for (j = i + 1; j <= N; j++) if (a[j] < a[i]) { t = a[i]; a[i] = a[j]; a[j] = t }
  for (i = 1; i <= N; i++) sum[i] = sum[i - 1] + a[i] ^ 2
  q = 0.8; p = q - 2; T = log(6); W = 10; H = 6.4
  window(-1.2, -3, 11.6, H + 0.3)
  for (i = 1; i <= N; i++) print "box", i % 2 ? "dcebf6" : "eef5fa", W * (i - 1) / N, 0, W * i / N, H
  row = ""; for (k = 0; k <= 60; k++) { t = T * (k / 60) ^ 0.7; row = row OFS W * E(p, t) / E(p, T) OFS H * E(q, t) / E(q, T) }
  line(grey, 0, 0, W, 0, 0.6); line(grey, 0, 0, 0, H, 0.6)
  print "curve", black, 1.1 row
  for (i = 1; i <= N; i++) { x = W * i / N; y = H * sum[i] / sum[N]; dash(2, 2); line(red, x - W / N, H * sum[i - 1] / sum[N], x, H * sum[i - 1] / sum[N], 0.7); dash(); line(red, x, H * sum[i - 1] / sum[N], x, y, 1.2); dot(red, x, y, 1.8) }
  # The discs in a row, each below its stratum.
  f = 0.115
  for (i = 1; i <= N; i++) { disc(light, blue, W * (i - 0.5) / N, -1.45, f * a[i]) }
  words(0, -0.4, "0"); words(W, -0.4, "1"); words(W / 2, -0.45, "$y$"); words(-0.55, H / 2, "$\\Lambda$"); words(-0.35, H, "1"); words(W / 2, -2.6, "the " N " radii of the pack")
}
