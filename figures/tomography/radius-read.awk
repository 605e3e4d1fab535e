# from: tomography-shaken/{made,shaken}.rdf.tsv radius-error/rdf@*.tsv
# radius-read.awk: what becomes of the first peak if radii scatter, or are taken wrongly: from the tables rdf@S.tsv of
# radius-error, S being the spread, and of tomography-shaken. There lengths are in median radii; here r is in radii a of the mean volume, and R = r / a1.
# first@S@W: g over 2 <= R < 2 + W with a1 = a; peak@S@W: the highest bin of width W from zero; read@S@W: from R = 2.
# first_change@S@W@E, ...: the part by which these change if a1 = (1 + E) a. implied@W: the spread at which first changes by
# -.4 if E is .05; implied_low@W: the part by which read, if E is -.05, is above first, if E is 0. gauss_width, gauss_inside: the
# deviation of a normal curve, and how far inside 2 its middle is, that does both for E of .05 and -.05 by its values at 2. top@S, top_R@S: height and place of the peak by a parabola
# over half a standard deviation of a_i + a_j to either side; smeared@S, smeared_R@S: of the curve of equal spheres, smeared;
# h, area, depth: of equal spheres the value at contact, the area above 1 and, over h - 1, its depth w; model@S,
# model_R@S: the peak of 1 + (h - 1) exp(-y / w), smeared; limit@S, limit_R@S: the same for spreads above w.
# shaken@S: how much lower the peak of the packs of tomography-shaken is after shaking than before, if smeared.
# Errors are of bins taken as independent. dir/near.tsv: S, r, g, its error, g smeared; dir/wrong.tsv: S, E (error) and, of
# bins of 0.02, first and read against first at the right radius.
function row(name, value, error) { if (error == "") printf "%s\t%.4g\t0\n", name, value; else printf "%s\t%.12g\t%.12g\n", name, value, error }
function least(x, y) { return x < y ? x : y }
function most(x, y) { return x > y ? x : y }
# The mean of g over the shell u to v, its error in err.
function mean(S, u, v,   b, p, q, w, sum, var, to) {
  sum = var = 0; to = least(bins[S], int((v - low[S]) / d[S]) + 1)
  for (b = most(0, int((u - low[S]) / d[S])); b < to; b++) {
    p = most(u, low[S] + b * d[S]); q = least(v, low[S] + (b + 1) * d[S])
    if (q <= p) continue
    w = (q ^ 3 - p ^ 3) / (v ^ 3 - u ^ 3); sum += w * g[S, b]; var += (w * e[S, b]) ^ 2
  }
  err = sqrt(var)
  return sum
}
# The highest bin of width W of R = r / f from R = from on.
function highest(S, f, W, from,   k, m, best) {
  best = 0
  for (k = int(from / W + 0.5); k < 2.4 / W; k++) { m = mean(S, k * W * f, (k + 1) * W * f); if (m > best) { best = m; best_err = err } }
  err = best_err
  return best
}
function stat(kind, S, f, W) { return kind == "first" ? mean(S, 2 * f, (2 + W) * f) : highest(S, f, W, kind == "read" ? 2 : 1.6) }
# The share of the normal law between x and y, by Simpson's rule.
function normal(x, y,   h, i, n, sum) {
  x = most(x, -9); y = least(y, 9)
  if (y <= x) return 0
  n = 2 * int((y - x) / 0.2 + 2); h = (y - x) / n
  for (i = sum = 0; i <= n; i++) sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * exp(-(x + i * h) ^ 2 / 2)
  return sum * h / 3 / 2.506628274631
}
# g of the equal spheres Q, its bins taken as steps, at r - (a_i + a_j) + 2, on average: a_i + a_j has the mean 2 exp(-s^2) and the
# standard deviation sqrt(2) s, to the second order in s.
function smeared(Q, s, r,   b, y, sum, to) {
  y = r - 2 * exp(-s * s); sigma = sqrt(2) * s; to = least(bins[Q], int((y + 6 * sigma) / d[Q]) + 1)
  sum = 0
  for (b = most(0, int((y - 6 * sigma) / d[Q])); b < to; b++) sum += g[Q, b] * normal((b * d[Q] - y) / sigma, ((b + 1) * d[Q] - y) / sigma)
  return sum
}
function peak_smeared(Q, s,   r, f, best) {
  best = 0
  for (r = 1.98; r < 2.15; r += 0.001) if ((f = smeared(Q, s, r)) > best) { best = f; top_R = r }
  return best
}
function model(s, r,   y, q) {
  y = r - 2 * exp(-s * s); sigma = sqrt(2) * s; q = sigma / depth
  return normal(-9, y / sigma) + (h - 1) * exp(q * q / 2 - y / depth) * normal(-9, y / sigma - q)
}
# The vertex of the parabola by least squares through the n bins to either side of bin m; its errors in err, err_R.
function vertex(S, m, n,   j, c0, c1, c2, S2, S4, N, T0, T1, T2, v0, v1) {
  N = 2 * n + 1
  for (j = -n; j <= n; j++) { S2 += j ^ 2; S4 += j ^ 4; T0 += g[S, m + j]; T1 += j * g[S, m + j]; T2 += j * j * g[S, m + j] }
  c2 = (T2 - S2 / N * T0) / (S4 - S2 * S2 / N); c0 = (T0 - S2 * c2) / N; c1 = T1 / S2
  for (j = -n; j <= n; j++) { v0 += (e[S, m + j] / N) ^ 2; v1 += (j * e[S, m + j] / S2) ^ 2 }
  err = 1.5 * sqrt(v0); err_R = sqrt(v1) / (-2 * c2) * d[S]; top_R = low[S] + (m + 0.5 - c1 / (2 * c2)) * d[S]
  return c0 - c1 * c1 / (4 * c2)
}
function column(c,   i) {
  for (i = 1; i <= NF; i++) if ($i == c) return i
  print "radius-read.awk: " FILENAME ": no column " c > "/dev/stderr"; failed = 1; exit 1
}
FNR == 1 {
  named = 0
  S = FILENAME; sub(/.*\//, "", S); sub(/rdf@/, "", S); sub(/\.(rdf\.)?tsv$/, "", S); scale = exp(1.5 * S * S)
  if (S + 0 || S == "0") name[++names] = S
}
/^#/ { next }
!named { named = 1; R = column("R"); G = column("g"); E = column("g_err"); next }
{ b = bins[S]++; if (b == 0) low[S] = $R; if (b == 1) { d[S] = ($R - low[S]) / scale; low[S] = low[S] / scale - d[S] / 2 } g[S, b] = $G; e[S, b] = $E }
function over_first(S, W) { over[S, W] = stat("read", S, 0.95, W) / stat("first", S, 1, W) - 1 }
function changes(S, kind, W,   right, right_err, E, x) {
  right = stat(kind, S, 1, W); right_err = err; row(kind "@" S "@" W, right, right_err)
  for (E = -0.05; E < 0.06; E += 0.1) {
    x = stat(kind, S, 1 + E, W) / right
    change[kind, S, W, E > 0] = x - 1
    row(sprintf("%s_change@%s@%s@%.2g", kind, S, W, E), x - 1, sqrt((err / right) ^ 2 + (x * right_err / right) ^ 2))
  }
}
function implied(W,   i, S, T, u) {
  for (i = 2; i <= names; i++) {
    S = name[i - 1]; T = name[i]
    if (change["first", S, W, 1] < -0.4 && change["first", T, W, 1] >= -0.4) {
      u = (-0.4 - change["first", S, W, 1]) / (change["first", T, W, 1] - change["first", S, W, 1])
      row("implied@" W, S + u * (T - S)); row("implied_low@" W, over[S, W] + u * (over[T, W] - over[S, W]))
    }
  }
}
function place(S,   b, m, r, f, best) {
  m = 0
  for (b = 0; b < bins[S]; b++) if (g[S, b] > g[S, m]) m = b
  best = vertex(S, m, most(1, int(0.7 * S / d[S] + 0.5))); row("top@" S, best, err); row("top_R@" S, top_R, err_R)
  row("smeared@" S, peak_smeared("0", S)); row("smeared_R@" S, top_R)
  row("shaken@" S, peak_smeared("shaken", S) / peak_smeared("made", S) - 1)
  best = 0
  for (r = 1.98; r < 2.15; r += 0.001) if ((f = model(S, r)) > best) { best = f; top_R = r }
  row("model@" S, best); row("model_R@" S, top_R)
  row("limit@" S, 0.5 + area / (sqrt(2 * 3.14159265359) * sigma)); row("limit_R@" S, 2 * exp(-S * S) + depth + sigma ^ 2 / area)
}
function figures(S,   b, r, E, right, top) {
  for (b = 0; (r = low[S] + (b + 0.5) * d[S]) < 2.4; b++)
    if (r > 1.75) print S, sprintf("%.5f", r), g[S, b], e[S, b], (S + 0 ? smeared("0", S, r) : "nan") > (dir "/near.tsv")
  right = stat("first", S, 1, 0.02)
  for (E = -0.1; E < 0.1005; E += 0.0025)
    print S, E, stat("first", S, 1 + E, 0.02) / right - 1, stat("read", S, 1 + E, 0.02) / right - 1 > (dir "/wrong.tsv")
}
BEGIN { FS = OFS = "\t" }
END {
  if (failed) exit 1
  print "S", "r", "g", "g_err", "smeared" > (dir "/near.tsv"); print "S", "error", "first", "read" > (dir "/wrong.tsv")
  print "quantity\tvalue\tstandard_error"
  for (i = 2; i <= names; i++) for (j = i; j > 1 && name[j] + 0 < name[j - 1] + 0; j--) { S = name[j]; name[j] = name[j - 1]; name[j - 1] = S }
  err = 0; h = g["0", 0] + (g["0", 0] - g["0", 1]) / 2; row("h", h, sqrt(2.25 * e["0", 0] ^ 2 + e["0", 1] ^ 2 / 4))
  for (b = 0; g["0", b] > 1; b++) { area += (g["0", b] - 1) * d["0"]; err += (e["0", b] * d["0"]) ^ 2 }
  depth = area / (h - 1); row("area", area, sqrt(err)); row("depth", depth)
  gauss = 0.01 / -(log(0.6) + log(1.07)); row("gauss_width", sqrt(gauss)); row("gauss_inside", 5 * gauss * (log(1.07) - log(0.6)))
  widths = split("0.01 0.02 0.05 0.1", width, " ")
  for (i = 1; i <= names; i++) {
    for (j = 1; j <= widths; j++) {
      changes(name[i], "first", width[j]); changes(name[i], "peak", width[j]); changes(name[i], "read", width[j]); over_first(name[i], width[j])
    }
    if (name[i] + 0) place(name[i])
    figures(name[i])
  }
  for (j = 1; j <= widths; j++) implied(width[j])
}
