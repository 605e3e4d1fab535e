# zeta-rows.awk: rows of a table from summaries: the pack's name, the fraction, zeta2 and eta2 with the error of their last digits. Before each file
# name=NAME; only=PREFIX of the quantities; pick=VALUE of the first key of a sweep over two.
function shown(v, e,   d, part) {
  if (e == "nan" || e == "-nan" || e + 0 == 0) {
    if (v >= 1e-3) return sprintf("%.8f", v)
    split(sprintf("%.5e", v), part, "e")
    return part[1] "\\cdot10^{" (part[2] + 0) "}"
  }
  d = 1 - int(log(e) / log(10)); if (e < 1 && 10 ^ (1 - d) > e) d++
  return sprintf("%.*f(%.0f)", d, v, e * 10 ^ d)
}
BEGIN { FS = "\t" }
FNR == 1 { print "\\midrule"; said = 0 }
/^#/ { next }
{
  n = split($1, part, "@")
  if (part[1] == only "zeta2") { zeta = $2; error = $3 }
  if (part[1] != only "eta2" || (pick != "" && part[2] != pick)) next
  printf "%s & %s & $%s$ & $%s$\\\\\n", said++ ? "" : name, part[n], shown(zeta, error), shown($2, $3)
}
