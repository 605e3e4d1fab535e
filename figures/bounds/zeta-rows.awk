# zeta-rows.awk: rows of a table from summaries: the pack's name, the fraction, zeta2 and eta2 with the error of their last digits. Before each file
# name=NAME; only=PREFIX of the quantities; pick=VALUE of the first key of a sweep over two. The fraction is the last key's; without a sweep
# that of the packs.
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
FNR == 1 { print "\\midrule"; said = 0; phi = "" }
/^#/ { next }
{
  n = split($1, part, "@")
  if ($1 == "fraction") phi = sprintf("%.3f", $2)
  if (part[1] == only "zeta2") { zeta = $2; error = $3 }
  if (part[1] != only "eta2" || (pick != "" && part[2] != pick)) next
  printf "%s & %s & $%s$ & $%s$\\\\\n", said++ ? "" : name, (n > 1 ? part[n] : phi), shown(zeta, error), shown($2, $3)
}
