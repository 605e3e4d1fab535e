# paper/findings.awk: judge claims, of data/claims.tsv or data/controls.tsv, by the summaries of the runs. Each rule is an
# interval of the values that the claim allows:
#   ~ T         a printed number: T to half a unit of its last digit as typed; "~ about T": to a whole unit
#   in LOW HIGH a printed range, "in about LOW HIGH": a whole unit wider at both ends; same: a ratio that is 1 to 0.02;
#   < T, > T    an inequality
#   = T         a statement of mathematics, of a quantity without error: T to a millionth
# The measurement is the interval of four standard errors to either side. The claim holds if that lies inside the claim's
# interval, does not hold if the two have no point in common, and is undecided otherwise. A measured "-" is untested.
# In a draft (-v draft=1) a quantity that a few packs do not have is untested. Writes, between tabs: claim, where, value, se, verdict, number, claimed, tolerance, measured, remark.
BEGIN { FS = OFS = "\t"; errors = 4; alike = 0.02 }
FILENAME == ARGV[1] { if (!/^#/ && NF) row[++rows] = $0; next }
FNR == 1 { m = split(FILENAME, path, "/"); scene = path[m - 1] }
/^#/ || $1 == "quantity" { next }
{ value[scene "@" $1] = $2; se[scene "@" $1] = $3 == "nan" || $3 == "-nan" ? 0 : $3 }
function wrong(what) { print ARGV[1] ": row " number ": " what > "/dev/stderr"; failed = 1 }
# The value and the error e of "SCENE@QUANTITY", or of two joined by - or /. "KEY|0" is 0 where there is no such row.
function one(key) {
  if (sub(/\|0$/, "", key) && !(key in value)) { found = 0; return 0 }
  if (!(key in value)) { if (draft) missing = 1; else wrong("no quantity " key); found = 0; return 0 } # reading value[key] would make it
  found = se[key] + 0
  return value[key] + 0
}
function measure(what,   term, parts, v, w, f) {
  parts = split(what, term, " ")
  if (parts != 1 && parts != 3) wrong("one quantity, or two joined by - or /: " what)
  v = one(term[1]); e = found
  if (parts < 3) return v
  w = one(term[3]); f = found
  if (term[2] == "-") { e = sqrt(e * e + f * f); return v - w }
  if (w == 0) { if (draft) missing = 1; else wrong("nothing to divide by: " what); return 0 }
  e = sqrt((e / w) ^ 2 + (v * f / w / w) ^ 2)
  return v / w
}
# A unit of the last digit of a number as it is typed: 1 of 12, 0.01 of 9.55.
function unit(typed) { sub(/^[^.]*\.?/, "", typed); return 10 ^ -length(typed) }
function absolute(x) { return x < 0 ? -x : x }
# The claimed interval: low, high; and in words.
function claim(rule,   c, parts) {
  low = -1e300; high = 1e300; tolerance = "-"
  parts = split(rule, c, " "); claimed = c[2]
  if (c[1] == "~") {
    claimed = c[parts]; tolerance = c[2] == "about" ? unit(claimed) : unit(claimed) / 2
    if (parts == 3) claimed = "about " claimed
  } else if (c[1] == "same") { claimed = 1; tolerance = alike }
  else if (c[1] == "=") { claimed = c[2]; tolerance = 0 }
  else if (c[1] == "in") {
    tolerance = parts == 4 ? unit(c[3]) : 0; low = c[parts - 1] - tolerance; high = c[parts] + tolerance
    claimed = (parts == 4 ? "about " : "") c[parts - 1] " to " c[parts]; return
  }
  else if (c[1] == "<") { high = c[2]; claimed = rule; return }
  else if (c[1] == ">") { low = c[2]; claimed = rule; return }
  else wrong("no such rule: " rule)
  low = high = c[1] == "same" ? 1 : c[parts] + 0
  low -= c[1] == "=" ? 1e-6 * (absolute(low) > 1e-3 ? absolute(low) : 1e-3) : tolerance + 1e-9 * absolute(low)
  high += high - low
}
function verdict(v) {
  if (v - errors * e >= low && v + errors * e <= high) return "holds"
  if (v - errors * e > high || v + errors * e < low) return "does not hold"
  return "undecided"
}
END {
  print "claim", "where", "value", "se", "verdict", "number", "claimed", "tolerance", "measured", "remark"
  for (i = 1; i <= rows; i++) {
    if (split(row[i], c, FS) != 7) { wrong("not seven columns: " row[i]); continue }
    number = c[1] "" (++count[c[1]])
    if (c[4] == "-") { print c[3], c[1] " " c[2], "nan", "nan", "untested", number, "-", "-", "-", c[7]; continue }
    missing = 0; v = measure(c[4]); claim(c[5])
    if (missing) { print c[3], c[1] " " c[2], "nan", "nan", "untested", number, claimed, tolerance, c[4], "not in this draft"; continue }
    if (c[5] ~ /^=/ && e > 0) wrong("an exact claim (=) of a quantity with an error: " c[4])
    judged = verdict(v)
    print c[3], c[1] " " c[2], sprintf("%.12g", v), sprintf("%.12g", e), judged, number, claimed, tolerance, c[4], \
      judged == "holds" ? c[6] : judged == "undecided" ? "" : c[7]
  }
  exit failed
}
