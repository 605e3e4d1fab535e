# from: two-hard/S2@*.tsv two-penetrable/{S2,boolean}@*.tsv two-aspect/S2@*.tsv two-exponent/S2@*.tsv two-polygons/S2@*.tsv two-grains/{S2,boolean}@*.tsv two-ellipses/{S2,boolean}@*.tsv two-roads/made.S2@*.tsv two-roads/shaken.S2@*.tsv two-thrown/S2.tsv two-thrown/boolean.tsv
# two-points.awk: what is read off two-point functions. A curve is SCENE@VALUE, without the scene's `two-`; made and shaken stand before. Of h = S_aa - phi^2:
#   half        the R at which it has fallen to half of phi - phi^2
#   trough, trough_R, peak, peak_R   its least value, by phi - phi^2, with the sign changed; its largest beyond; and where
#   wave        the peak less the trough, the depth of its oscillation
#   fades       the peak by the depth of the trough
#   back        r / D_eq where it returns through zero after the trough
# A trough or a peak is told if it is four errors from 0. Of two curves, NAME:
#   apart, apart_R, sigma   their largest difference, by phi - phi^2, where, and the largest in its standard errors
#   first_law, first_number of packs and their law: S_aa less the law at the first R
#   law, law_sigma          the same of packs and their law, not by phi - phi^2; number, number_sigma: the law of their number
# Of packs that cover phi exactly: tail, the mean of S_aa less the law beyond R = 3, where no grain reaches, with the mean of the errors, which is
# more than the error of the mean, tail@half of all shapes at .5; and excess, what the mean of the law over the box is larger than phi^2 by.
# longest: the longest segment within a regular polygon, by a: a diagonal, or the side of a triangle.
# The squares of errors add: of a pack before and after shaking, and of the peak and the trough of one curve, that is too much rather than too little.
function name_of(path,   part, n, s) {
  n = split(path, part, "/"); s = part[n - 1]; sub(/^two-/, "", s); file = part[n]; sub(/\.tsv$/, "", file)
  kind = file; sub(/@.*/, "", kind); sub(/[^@]*/, "", file)
  return s file
}
function short(x) { return sprintf("%.2g", x) + 0 }
function row(name, value, error) { printf "%s\t%.12g\t%.12g\n", name, value, error }
BEGIN { FS = "\t"; print "# written by two-points.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { name = name_of(FILENAME); head = 0; law = kind == "boolean"; if (kind == "made.S2" || kind == "shaken.S2") { sub(/\.S2/, "", kind); name = kind "-" name } }
/^#/ { next }
!head { delete at; for (k = 1; k <= NF; k++) at[$k] = k; head = 1; b = 0; if (!law) order[++curves] = name; next }
law { fixed[name, b] = $at["S2_phi"]; exact[name, b++] = $at["S2_N"]; next }
{
  R[name, b] = $at["R"]; S[name, b] = $at["S2"]; e[name, b] = $at["S2_err"]
  n[name] = ++b
}
function abs(x) { return x < 0 ? -x : x }
function h(c, b) { return S[c, b] - S[c, 0] ^ 2 }
function unit(c) { return S[c, 0] - S[c, 0] ^ 2 }
# Where the line between two points has this value of h.
function cross(c, b, level) { return R[c, b - 1] + (R[c, b] - R[c, b - 1]) * (level - h(c, b - 1)) / (h(c, b) - h(c, b - 1)) }
function steep(c, b) { return abs(h(c, b) - h(c, b - 1)) / (R[c, b] - R[c, b - 1]) }
function shape(c,   b, low, high) {
  for (b = 1; h(c, b) > unit(c) / 2; b++) { }
  row("half@" c, cross(c, b, unit(c) / 2), e[c, b] / steep(c, b))
  for (low = 0; b < n[c]; b++) if (h(c, b) < h(c, low)) low = b
  if (h(c, low) > -4 * e[c, low]) return
  row("trough@" c, -h(c, low) / unit(c), e[c, low] / unit(c)); row("trough_R@" c, R[c, low], 0)
  for (b = high = low; b < n[c]; b++) if (h(c, b) > h(c, high)) high = b
  if (h(c, high) < 4 * e[c, high]) return
  row("peak@" c, h(c, high) / unit(c), e[c, high] / unit(c)); row("peak_R@" c, R[c, high], 0)
  row("wave@" c, (h(c, high) - h(c, low)) / unit(c), sqrt(e[c, low] ^ 2 + e[c, high] ^ 2) / unit(c))
  row("fades@" c, h(c, high) / -h(c, low), sqrt((e[c, high] / h(c, low)) ^ 2 + (h(c, high) * e[c, low] / h(c, low) ^ 2) ^ 2))
  for (b = low + 1; h(c, b) < 0; b++) { }
  row("back@" c, cross(c, b, 0) / 2, e[c, b] / steep(c, b) / 2)
}
function apart(name, c, d,   b, far, sigma, s, error) {
  for (b = 1 + (far = sigma = 0); b < n[c]; b++) {
    error = sqrt(e[c, b] ^ 2 + e[d, b] ^ 2); s = abs(S[c, b] - S[d, b])
    if (s > abs(S[c, far] - S[d, far])) far = b
    if (error > 0 && s / error > sigma) sigma = s / error
  }
  row("apart@" name, abs(S[c, far] - S[d, far]) / unit(c), sqrt(e[c, far] ^ 2 + e[d, far] ^ 2) / unit(c))
  row("apart_R@" name, R[c, far], 0); row("sigma@" name, short(sigma), 0)
}
function lawful(c, rule, what,   b, far, sigma, s) {
  for (b = 1 + (far = sigma = 0); b < n[c]; b++) {
    s = abs(S[c, b] - rule[c, b])
    if (s > abs(S[c, far] - rule[c, far])) far = b
    if (e[c, b] > 0 && s / e[c, b] > sigma) sigma = s / e[c, b]
  }
  row("first_" what "@" c, S[c, 1] - rule[c, 1], e[c, 1])
  row(what "@" c, abs(S[c, far] - rule[c, far]), e[c, far]); row(what "_sigma@" c, short(sigma), 0)
}
# S's box is 40 radii wide.
function beyond(c,   b, sum, noise, m, excess) {
  for (b = 0; b < n[c]; b++) {
    excess += 2 * pi * R[c, b] * (R[c, 1] - R[c, 0]) * (fixed[c, b] - S[c, 0] ^ 2) / 1600
    if (R[c, b] > 3) { sum += S[c, b] - fixed[c, b]; noise += e[c, b]; m++ }
  }
  row("tail@" c, sum / m, noise / m); row("excess@" c, short(excess), 0)
  if (c ~ /^(grains|ellipses)@/) { tails += sum / m; noises += (noise / m) ^ 2; many++ }
}
END {
  pi = 3.14159265358979
  row("longest@3", int(1e3 * 2 * sqrt(pi / sqrt(3)) + 0.5) / 1e3, 0); row("longest@4", int(1e3 * sqrt(2 * pi) + 0.5) / 1e3, 0); row("longest@6", int(1e3 * 2 * sqrt(2 * pi / (3 * sqrt(3))) + 0.5) / 1e3, 0)
  for (i = 1; i <= curves; i++) {
    c = order[i]; shape(c)
    if ((c, 1) in fixed && c != "thrown") { lawful(c, fixed, "law"); beyond(c) }
    if (c ~ /^shaken/) { d = c; sub(/shaken/, "made", d); apart(c, c, d) }
    if (c ~ /^hard@/) { d = c; sub(/hard/, "penetrable", d); apart("hard-penetrable" substr(c, 5), c, d) }
  }
  row("tail@half", tails / many, sqrt(noises) / many)
  lawful("thrown", exact, "number"); lawful("thrown", fixed, "law")
  apart("round-hard", "polygons@4", "aspect@2.28367"); apart("round-penetrable", "grains@4", "ellipses@2.28367")
  apart("exponents", "exponent@1", "exponent@50"); apart("aspects", "aspect@1", "aspect@5")
  for (k = 3; k <= 6; k++) { apart("disc-hard@" k, "polygons@" k, "exponent@1"); apart("disc-penetrable@" k, "grains@" k, "ellipses@1") }
  apart("triangle-square-hard", "polygons@3", "polygons@4"); apart("triangle-square-penetrable", "grains@3", "grains@4")
  apart("roads", "made-roads@dynamics", "made-roads@area"); apart("roads-shaken", "shaken-roads@dynamics", "shaken-roads@area")
}
