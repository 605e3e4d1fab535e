# paper/hard.awk: build/hard.tsv as a table of the book, and into the file `score` how many ended as promised. The first three columns are LaTeX; what was
# measured is plain text.
function plain(s,   i, c, t) {
  for (i = 1; i <= length(s); i++) {
    c = substr(s, i, 1)
    if (c == "\\") c = "\\textbackslash{}"
    else if (c ~ /[_%&#$\{\}]/) c = "\\" c
    else if (c ~ /[\^~]/) c = "\\" c "{}"
    else if (c ~ /[<>|]/) c = "$" c "$"
    else if (c == "\"") c = "\\textquotedbl{}"
    else if (c ~ /[.:\/]/ && substr(s, i + 1, 1) ~ /[a-z]/) c = c "\\allowbreak{}"
    t = t c
  }
  return t
}
BEGIN {
  FS = "\t"
  cell = "\\raggedright\\hspace{0pt}"
  print "{\\footnotesize\\setlength\\tabcolsep{4pt}"
  print "\\begin{longtable}{@{}p{5.6pc}p{7.6pc}p{7.8pc}p{8pc}l@{}}\\toprule"
  print "case & how provoked & promised & measured & \\\\\\midrule\\endhead\\bottomrule\\endfoot"
}
{
  print cell $1 " & " cell $2 " & " cell $3 " & " cell "\\arraybackslash " plain($4) " & " \
    ($5 == "pass" ? "pass" : "\\textbf{FAIL}") "\\\\\\addlinespace[2pt]"
  cases++
  passed += $5 == "pass"
}
END {
  print "\\end{longtable}}"
  print "\\newcommand\\hardcases{" cases "}\\newcommand\\hardpassed{" passed "}" > score
}
