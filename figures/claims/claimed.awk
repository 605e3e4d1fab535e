# from: theory-curves/theory.tsv theory-curves/summary.tsv first-peak/summary.tsv bimodal/summary.tsv gravity-discs/summary.tsv rsa-saturation-3d/summary.tsv first-peak/shaken.rdf@retry@{0.575,0.6}.tsv bimodal/shaken.partial.{L-L,L-S,S-S}@retry@{3,60}.tsv
# claimed.awk: what some claims need and no single quantity of a run says. From summaries and tables, of which
# it finds the columns by their names; lengths in radii. Errors are of quantities and bins taken as independent.
# order_right, order_central: the power of the step in the error of the quotients (14), at R = 3 on Percus and Yevick's curve
# at .575; quotients: central by right there, at a step of .01. twins: g_12 by g_21 of (20), half a small radius beyond contact;
# least: the least value of (20) for g_11. growth: (17)'s factor from .575 to .60 over the ratio of the excess contact values of
# shaken packs; carried_peak, carried_gap: what (17) predicts about R = 4 and in the gap, over what is measured.
# rise_4, rise_3.46: height of the third and the second peak at .63 by that at .575. willis_4: the excess of Willis's curve at 4 by that of
# packs. pronounced: g_11 within .05 of 4.54 by its mean on both sides. forgotten_12, forgotten_22: mean square of the difference of
# 60 and 3 shakes by its error, from R = 2.5 on. noisy: the error of a bin of g_11 by that of g_22, beyond the first peak. multiplied: 1 - (1 - phi)^2
# of discs by gravity. willis_sign: the c at which Willis's g_c, a line in 1 / c, is zero. saturated: how much denser spheres added at random are than in [torquato2006].
function row(name, v, e) { printf "%s\t%.12g\t%.12g\n", name, v, e + 0 }
function get(scene, name) {
  if (!((scene, name) in value)) { print "claimed.awk: no " name " of " scene > "/dev/stderr"; failed = 1 }
  slip = error[scene, name] + 0
  return value[scene, name] + 0
}
function ratio(a, ea, b, eb) { err = sqrt((ea / b) ^ 2 + (a * eb / b / b) ^ 2); return a / b }
# The number in a line of a table, and how many lines there are.
function at(t, column, line) { if (!((t, column) in place)) { print "claimed.awk: no " column " in " t > "/dev/stderr"; failed = 1 } return cell[t, place[t, column], line] }
# The mean of g over u < R < v, with R = (r - a) / b + 1, and its error in err.
function mean(t, u, v, a, b,   k, R, n, sum, var) {
  for (k = 1; k <= lines[t]; k++) {
    R = (at(t, "R", k) - a) / b + 1
    if (R > u && R < v) { n++; sum += at(t, "g", k); var += at(t, "g_err", k) ^ 2 }
  }
  err = sqrt(var) / n
  return sum / n
}
# Pairs between u and v by Simpson's rule on the curve in steps of .005: the integral of 4 pi R^2 g.
function counted(u, v,   k, n, sum, R) {
  n = int((v - u) / 0.005 + 0.5)
  for (k = 0; k <= n; k++) {
    R = u + k * 0.005
    sum += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * R * R * at("theory", "py_0.575", int((R - 2) / 0.005 + 1.5))
  }
  return 4 * pi * sum * 0.005 / 3
}
function quotient(from, step) { return counted(from, from + step) / (4 * pi * 9 * step) }
function orders(   g, s) {
  g = at("theory", "py_0.575", 201); s = 0.04
  row("order_right", log((quotient(3, s) - g) / (quotient(3, s / 2) - g)) / log(2))
  row("order_central", log((quotient(3 - s / 2, s) - g) / (quotient(3 - s / 4, s / 2) - g)) / log(2))
  row("quotients", quotient(3 - 0.005, 0.01) / quotient(3, 0.01))
}
function model(c, R) { return 1 + (c - 1) * cos(pi * R) * exp(2 * (2 - R)) }
function twins(   c, l) {
  l = 0.313; c = get("bimodal", "contact_py.L-S@retry@60")
  row("twins", model(c, 2.5) / model(c, 2 + l / 2))
  row("least", model(get("bimodal", "contact_py.L-L@retry@60"), 3 - atan2(2, pi) / pi))
}
function sign(   a, b) {
  a = get("theory-curves", "willis_0.49_contact") - 1; b = get("theory-curves", "willis_0.575_contact") - 1
  row("willis_sign", (b - a) / (b / 0.49 - a / 0.575))
}
function willis(c) { return 0.8006 * (8 * c - 1) / c }
function carried(name, u, v, f,   to, e) {
  to = mean("0.6", u, v, 1, 1); e = err
  f = 1 + f * (mean("0.575", u, v, 1, 1) - 1)
  f = ratio(f, err, to, e); row(name, f, err)
}
function extrapolate(   f, a, ea) {
  f = willis(0.6) / willis(0.575)
  a = get("first-peak", "shaken.contact@retry@0.6") - 1; ea = slip
  a = ratio(a, ea, get("first-peak", "shaken.contact@retry@0.575") - 1, slip); ea = err
  a = ratio(f, 0, a, ea); row("growth", a, err)
  carried("carried_peak", 3.9, 4.1, f); carried("carried_gap", 2.6, 2.9, f)
}
function rise(name, peak,   a, ea) {
  a = get("first-peak", "made." peak "_g@retry@0.63"); ea = slip
  a = ratio(a, ea, get("first-peak", "made." peak "_g@retry@0.575"), slip); row(name, a, err)
}
function bump(   a, ea, b, eb) {
  a = mean("L-L60", 4.49, 4.59, 1, 1); ea = err; b = mean("L-L60", 4.39, 4.49, 1, 1); eb = err
  b = (b + mean("L-L60", 4.59, 4.69, 1, 1)) / 2; eb = sqrt(eb ^ 2 + err ^ 2) / 2
  a = ratio(a, ea, b, eb); row("pronounced", a, err)
}
function forgotten(name, t, a, b,   k, n, d, sum, more) {
  for (k = 1; k <= lines[t "3"]; k++) {
    if ((at(t "3", "R", k) - a) / b + 1 < 2.5) continue
    d = at(t "60", "g_err", k) ^ 2 + at(t "3", "g_err", k) ^ 2
    if (!(d > 0)) continue # two packs alike say nothing
    d = (at(t "60", "g", k) - at(t "3", "g", k)) ^ 2 / d
    n++; sum += d; more += d * d
  }
  row(name, sum / n, sqrt((more / n - (sum / n) ^ 2) / n))
}
function scatter(t, from, a, b,   k, n, sum, R) {
  for (k = 1; k <= lines[t]; k++) { R = (at(t, "R", k) - a) / b + 1; if (R > from) { n++; sum += at(t, "g_err", k) ^ 2 } }
  err = sqrt(sum / n) * sqrt(0.5 / n) # of a mean of n squares of normal deviates
  return sqrt(sum / n)
}
function noisy(   a, ea) {
  a = scatter("L-L60", 2.5, 1, 1); ea = err
  a = ratio(a, ea, scatter("S-S60", 2.5, 0.313, 0.313), err); row("noisy", a, err)
}
FNR == 1 {
  m = split(FILENAME, path, "/"); scene = path[m - 1]; table = path[m]; head = 0
  sub(/^(shaken\.(rdf|partial)[.@])?/, "", table); sub(/\.tsv$/, "", table); sub(/^retry@/, "", table); sub(/@retry@/, "", table)
}
/^#/ { next }
table == "summary" { value[scene, $1] = $2; error[scene, $1] = $3 == "nan" || $3 == "-nan" ? 0 : $3; next }
!head { for (k = 1; k <= NF; k++) place[table, $k] = k; head = 1; next }
{ lines[table]++; for (k = 1; k <= NF; k++) cell[table, k, lines[table]] = $k }
BEGIN { FS = "\t"; pi = 3.14159265358979; print "# written by claimed.awk\nquantity\tvalue\tstandard_error" }
END {
  orders(); twins(); sign(); extrapolate(); rise("rise_4", "peak2"); rise("rise_3.46", "peak1")
  g = get("first-peak", "made.peak2_g@retry@0.575") - 1; row("willis_4", ratio(at("theory", "willis_0.575", 401) - 1, 0, g, slip), err)
  bump(); forgotten("forgotten_12", "L-S", 1, 0.313); forgotten("forgotten_22", "S-S", 0.313, 0.313); noisy()
  g = get("gravity-discs", "phi_0.6@30000"); row("multiplied", 1 - (1 - g) ^ 2, 2 * (1 - g) * slip)
  g = get("rsa-saturation-3d", "fraction"); row("saturated", g - 0.38278, sqrt(slip ^ 2 + 0.00005 ^ 2))
  exit failed
}
