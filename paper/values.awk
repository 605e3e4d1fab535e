# paper/values.awk: the numbers of build/data/NAME/summary.tsv that the first file lists, NAME@quantity, as LaTeX macros:
# \val{NAME}{quantity} is value(error), \valonly the value, \valerr the error. Those of the scenes in -v recorded="NAME NAME ..."
# bear the sign of what is recorded; seconds that belong to other code, another one.
function digits(x,   e) { # decimals that show two digits of x
  if (x <= 0) return 0
  e = int(log(x) / log(10)); if (log(x) < 0 && e * log(10) > log(x)) e--
  return 1 - e
}
function plain(x,   s) {
  s = sprintf("%.6g", x)
  if (s ~ /e/) { split(s, p, "e"); return p[1] "\\times10^{" (p[2] + 0) "}" }
  return s
}
BEGIN {
  FS = "\t"; n = split(recorded, path, " "); for (i = 1; i <= n; i++) sign[path[i]] = "\\recorded"
  print "% written from the summaries of the runs; do not edit"
}
NR == FNR { used[$0]; next }
FNR == 1 { n = split(FILENAME, path, "/"); name = path[n - 1] }
/^#/ || $1 == "quantity" || NF < 3 { next }
name == "seconds" && $1 == "other_code" && $2 > 0 { sign[name] = "\\othercode" }
!(name "@" $1 in used) || $2 ~ /nan/ { next } # nan is as good as missing
{
  key = name "@" $1; error = $3
  if (error == "nan" || error == "-nan" || error + 0 == 0) { v = plain($2); e = "0"; both = v }
  else {
    d = digits(error + 0)
    if (d >= 0) { v = sprintf("%.*f", d, $2); e = sprintf("%.*f", d, error); both = v "(" sprintf("%.0f", error * 10 ^ d) ")" }
    else { v = sprintf("%.0f", $2); e = sprintf("%.0f", error); both = v "(" e ")" }
  }
  printf "\\expandafter\\def\\csname val@%s\\endcsname{%s%s}", key, both, sign[name]
  printf "\\expandafter\\def\\csname only@%s\\endcsname{%s%s}", key, v, sign[name]
  printf "\\expandafter\\def\\csname err@%s\\endcsname{%s%s}\n", key, e, sign[name]
}
