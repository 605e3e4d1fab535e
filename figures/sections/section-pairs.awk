# from: sections-one/rdf.tsv sections-one/section_rdf.tsv
# section-pairs.awk: the pairs of discs in sections of equal spheres, beside what the pairs of spheres say, (sections:g), over the same bins:
#   gap     the largest difference, and sigma: the largest in standard errors of the discs' curve, of so many bins
#   contact the value of the discs' curve in the bin at R = 2
function row(name, value, error) { printf "%s\t%.12g\t%.12g\n", name, value, error }
BEGIN { FS = "\t"; n = m = 0; print "# written by section-pairs.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { head = 0; file++ }
/^#/ { next }
!head { delete at; for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
file == 1 { R[n] = $at["R"]; g[n++] = $at["g"]; next }
{ r[m] = $at["R"]; s[m] = $at["g"]; e[m++] = $at["g_err"] }
# g at this distance: 0 below contact, and between the middles of bins.
function of(x,   k, step) {
  step = R[1] - R[0]; k = int((x - R[0]) / step)
  return x < 2 ? 0 : k < 0 ? g[0] : g[k] + (g[k + 1] - g[k]) * ((x - R[0]) / step - k)
}
function disc_g(x,   t, sum) {
  for (t = 0.0025; t < 2; t += 0.005) sum += (2 - t) * of(sqrt(x ^ 2 + t ^ 2)) * 0.005 / 2
  return sum
}
END {
  for (b = 0; b < m; b++) {
    want = weight = 0
    for (u = -0.45; u < 0.5; u += 0.1) { x = r[b] + u * (r[1] - r[0]); want += x * disc_g(x); weight += x }
    want /= weight
    d = s[b] > want ? s[b] - want : want - s[b]
    if (d > gap) { gap = d; error = e[b] }
    if (e[b] > 0 && d / e[b] > sigma) sigma = d / e[b]
    if (r[b] > 2 && !contact) { contact = s[b]; contact_error = e[b] }
  }
  row("gap", gap, error); row("sigma", sprintf("%.1f", sigma), 0); row("bins", m, 0); row("contact", contact, contact_error)
}
