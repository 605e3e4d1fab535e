# paper/findings-tex.awk: findings.tsv or controls.tsv as a table of the book; with -v score=FILE the scoreboard, too: how many
# claims of each source have which verdict. Quantities of recorded runs bear the book's sign: -v recorded="SCENE SCENE ...".
BEGIN {
  FS = "\t"
  ways = split("holds,does not hold,undecided,untested", way, ",")
  many = split(recorded, name, " "); for (i = 1; i <= many; i++) sign[name[i]] = 1
  print "{\\footnotesize\\setlength\\tabcolsep{3pt}\\begin{longtable}{@{}lp{2.9pc}p{11.4pc}p{3.9pc}p{4.6pc}p{6.6pc}@{}}\\toprule"
  print "no. & place & claim; \\texttt{scene@quantity} & claimed & measured & verdict\\\\\\midrule\\endhead\\bottomrule\\endfoot"
}
# A number with the error in its last digits; rounded here and nowhere before.
function number(v, e,   d, m) {
  if (v == "nan") return "--"
  if (e > 0) {
    d = 1 - int(log(e) / log(10) - (e < 1)); d = d < 0 ? 0 : d
    m = sprintf("%.*f(%.0f)", d, v, e * 10 ^ d)
    if (d <= 7) return "$" m "$"
    m = sprintf(v * v < 1e-4 ? "%.3e" : "%.9g", v)
  } else m = sprintf("%.6g", v)
  if (m ~ /e/) { sub(/e\+?/, "\\cdot10^{", m); sub(/\{-0*/, "{-", m); m = m "}" }
  return "$" m "$"
}
function decimal(t) { t = sprintf("%.9f", t); sub(/\.?0+$/, "", t); return t }
# What the claim allows: printed as the source prints it.
function allowed(claimed, tolerance,   t) {
  t = claimed; sub(/ to /, "$ to $", t); sub(/^about /, "\\text{about }", t)
  if (sub(/1e-0*/, "10^{-", t)) t = t "}"
  return "$" t "$" (tolerance == "-" || tolerance == 0 ? "" : " $\\pm" decimal(tolerance) "$")
}
function code(s) { gsub(/[@._\/-]/, "&\\allowbreak{}", s); gsub(/_/, "\\_", s); gsub(/\^/, "\\^{}", s); return "\\texttt{\\scriptsize " s "}" }
function dagger(s,   part, k, n) {
  n = split(s, part, " ")
  for (k = 1; k <= n; k += 2) { sub(/@.*/, "", part[k]); if (part[k] in sign) return "\\recorded" }
  return ""
}
NR == 1 { next }
{
  split($2, where, " "); source = where[1]; place = substr($2, length(source) + 2)
  if (!(source in seen)) { seen[source] = 1; order[++sources] = source }
  count[source, $5]++; total[$5]++
  print $6 " & \\raggedright " place " & \\raggedright " $1 ($9 == "-" ? "" : "\\newline " code($9)) " & \\raggedright " \
    ($7 == "-" ? "" : allowed($7, $8)) " & " number($3, $4) ($9 == "-" ? "" : dagger($9)) " & \\raggedright\\arraybackslash " \
    ($5 == "holds" ? "holds" : "\\emph{" $5 "}") ($10 == "" ? "" : ": " $10) "\\\\[2pt]"
}
END {
  print "\\end{longtable}}"
  if (!score) exit
  printf "\\begin{tabular}{l" > score
  for (k = 1; k <= ways; k++) { printf "r" > score; line = line " & " way[k] }
  print "}\\toprule\n" line "\\\\\\midrule" > score
  for (i = 1; i <= sources; i++) {
    printf "\\source%s", order[i] > score
    for (k = 1; k <= ways; k++) printf " & %d", count[order[i], way[k]] > score
    print "\\\\" > score
  }
  print "\\bottomrule\\end{tabular}" > score
}
