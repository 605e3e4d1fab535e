# paper/findings.awk: judge the claims of data/claims.tsv by the summaries of the runs.
# Writes claim, where, value, se, verdict between tabs.
BEGIN { FS = OFS = "\t" }
FILENAME == ARGV[1] { if (!/^#/ && NF) claim[++n] = $0; next }
FNR == 1 { m = split(FILENAME, path, "/"); scene = path[m - 1] }
/^#/ || $1 == "quantity" { next }
{ value[scene "@" $1] = $2; se[scene "@" $1] = $3 == "nan" || $3 == "-nan" ? 0 : $3 }
function need(key) {
  if (sub(/\|0$/, "", key) && !(key in value)) return 0
  if (!(key in value)) { print "findings: no quantity " key > "/dev/stderr"; failed = 1 }
  return value[key]
}
function close_to(x, v, e) { return (x - v) ^ 2 <= (e > 0 ? 4 * e : 1e-6 * (v < 0 ? -v : v > 1e-3 ? v : 1e-3)) ^ 2 }
END {
  print "claim", "where", "value", "se", "verdict"
  for (i = 1; i <= n; i++) {
    split(claim[i], c, FS)
    parts = split(c[3], term, " ")
    v = need(term[1]); e = se[term[1]]
    if (parts == 3) {
      w = need(term[3]); f = se[term[3]]
      if (term[2] == "-") { v -= w; e = sqrt(e * e + f * f) }
      else { e = sqrt((e / w) ^ 2 + (v * f / w / w) ^ 2); v /= w }
    }
    split(c[4], rule, " ")
    good = rule[1] == "=" ? close_to(rule[2], v, e) : rule[1] == "<" ? v < rule[2] : rule[1] == ">" ? v > rule[2] : \
      (v - rule[2]) ^ 2 <= (rule[3] + 4 * e) ^ 2
    print c[2], c[1], sprintf("%.12g", v), sprintf("%.3g", e), good ? c[5] : c[6]
  }
  exit failed
}
