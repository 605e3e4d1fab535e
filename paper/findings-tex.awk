# paper/findings-tex.awk: build/findings.tsv as a table of the book.
BEGIN {
  FS = "\t"
  print "\\small\\begin{longtable}{@{}p{3.6pc}p{10pc}p{5pc}p{11pc}@{}}\\toprule"
  print "where & claim & measured & verdict\\\\\\midrule\\endhead\\bottomrule\\endfoot"
}
NR == 1 { next }
{
  if ($4 > 0) {
    d = 1 - int(log($4) / log(10) - ($4 < 1)); d = d < 0 ? 0 : d
    m = sprintf("%.*f(%.0f)", d, $3, $4 * 10 ^ d)
    if (d > 7) { m = sprintf("%.3e", $3); sub(/e/, "\\cdot10^{", m); sub(/\{-0*/, "{-", m); m = m "}" }
  } else m = sprintf("%.6g", $3)
  print "\\raggedright " $2 " & \\raggedright " $1 " & $" m "$ & \\raggedright\\arraybackslash " $5 "\\\\[2pt]"
}
END { print "\\end{longtable}" }
