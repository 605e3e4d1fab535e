# figures/book/map.awk: places for the modules, and arrows from each to those it includes, without those that
# follow from others. A part of few modules has the next one below it. Reads the chapters (for the parts) and the tangled *.[ch] (for the includes).
FILENAME ~ /\.nw$/ {
  if ($0 ~ /^\\part\{/) { next_part = $0; gsub(/^\\part\{|\}.*$/, "", next_part) }
  if ($0 ~ /^<<\[\[[a-z_]+\.c\]\]>>=/ && !(FILENAME in seen)) {
    seen[FILENAME] = 1; m = $0; gsub(/^<<\[\[|\.c.*$/, "", m)
    if (m == "randpack") next
    if (next_part != "") { # a part without modules has no column
      title[++part] = next_part; next_part = ""
      if (part > 1 && size[part - 1] < 10 && !below) { below = 1; rows[column]++ } else { below = 0; column++ }
      at[part] = column; top[part] = rows[column] + 0
    }
    size[part]++; col[m] = column; row[m] = rows[column]++; order[++n] = m
  }
  next
}
/^#include "/ {
  user = FILENAME; gsub(/.*\/|\.[ch]$/, "", user)
  used = $2; gsub(/"|\.h/, "", used)
  if (user != used && (used in col) && (user in col)) uses[user, used] = 1
}
# Is there a way from a to b through a third?
function implied(a, b,   c) {
  for (c in col) if (c != b && (a, c) in uses && reach[c, b]) return 1
  return 0
}
function x(m) { return (col[m] - 1) * 2 + (row[m] % 2 ? 0.35 : -0.35) }
function y(m) { return -row[m] * step }
END {
  for (c = 1; c <= column; c++) if (rows[c] > most) most = rows[c]
  step = most > 27 ? 21.6 / most : 0.8 # the longest part fits on a page
  print "kind\tx\ty\tdx\tdy\twords"
  for (k = 1; k <= n; k++) for (i = 1; i <= n; i++) for (j = 1; j <= n; j++) {
    a = order[i]; b = order[j]; c = order[k]
    if ((a, b) in uses) reach[a, b] = 1
    if (reach[a, c] && reach[c, b]) reach[a, b] = 1
  }
  for (k = 1; k <= n; k++) for (i = 1; i <= n; i++) for (j = 1; j <= n; j++)
    if (reach[order[i], order[k]] && reach[order[k], order[j]]) reach[order[i], order[j]] = 1
  for (i = 1; i <= n; i++) for (j = 1; j <= n; j++) {
    a = order[i]; b = order[j]
    if (((a, b) in uses) && !implied(a, b)) {
      dx = x(b) - x(a); dy = y(b) - y(a); s = 1 - 0.30 / sqrt(dx * dx + dy * dy)
      print "arrow\t" x(a) "\t" y(a) "\t" dx * s "\t" dy * s "\t"
    }
  }
  for (i = 1; i <= n; i++) print "module\t" x(order[i]) "\t" y(order[i]) "\t0\t0\t" order[i]
  for (i = 1; i <= part; i++) print "part\t" (at[i] - 1) * 2 "\t" 0.95 * step - top[i] * step "\t0\t0\t" title[i]
}
