# figures/tools/columns.awk: rows of tables by the names of their columns, with a line of names above. Tables come as files, options as
# NAME=VALUE before the tables that they are for:
#   where  conditions COLUMN=VALUE, COLUMN<VALUE or COLUMN>VALUE with semicolons between: the rows on which all of them hold;
#          a star at the end of a VALUE stands for anything
#   of     PATTERN with one star: the rows whose `quantity` fits, with a column `at` for what the star stands for
#   by     COLUMN or COLUMN;COLUMN: rows of several tables that agree there are one row, in the order of the first table, in which
#          the columns of the second table end in _2, and so on; without it, `at` if there is an `of`, else the first column
#   bin    so many rows become one: means, and in columns that end in _err the error of the mean; what is left over is dropped
#   get    COLUMN: nothing but its values, with blanks between
# What is not there is an error.
function fail(words) { print "columns.awk: " FILENAME ": " words > "/dev/stderr"; failed = 1; exit 1 }
function number(x) { return x ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/ }
function column(name,   i) {
  for (i = 1; i <= NF; i++) if ($i == name) return i
  fail("no column " name)
}
function header(   i, part) {
  conditions = split(where, condition, ";")
  for (i = 1; i <= conditions; i++) {
    match(condition[i], /[=<>][^=<>]*$/)
    sign[i] = substr(condition[i], RSTART, 1); limit[i] = substr(condition[i], RSTART + 1)
    tested[i] = column(substr(condition[i], 1, RSTART - 1))
  }
  if (of != "") { quantity = column("quantity"); $0 = $0 OFS "at" }
  keys = by == "" ? 1 : split(by, part, ";")
  for (i = 1; i <= keys; i++) key[i] = by != "" ? column(part[i]) : of != "" ? NF : 1
  for (i = 1; i <= NF; i++) name[++names] = $i (tables > 1 ? "_" tables : "")
}
function holds(i,   x, n) {
  x = $tested[i]; n = length(limit[i])
  if (substr(limit[i], n) == "*") return substr(x, 1, n - 1) == substr(limit[i], 1, n - 1)
  if (sign[i] == "=") return number(x) && number(limit[i]) ? x + 0 == limit[i] + 0 : x == limit[i] ""
  return sign[i] == "<" ? x + 0 < limit[i] + 0 : x + 0 > limit[i] + 0
}
# Does the quantity fit? Then `at` is added to the row.
function fits(   q, star, tail) {
  q = $quantity; star = index(of, "*"); tail = length(of) - star
  if (length(q) < length(of) || substr(q, 1, star - 1) != substr(of, 1, star - 1) ||
      substr(q, length(q) - tail + 1) != substr(of, star + 1)) return 0
  $0 = $0 OFS substr(q, star, length(q) - tail - star + 1)
  return 1
}
BEGIN { FS = OFS = "\t" }
FNR == 1 { tables++; named = 0 }
/^#/ { next }
!named { named = 1; header(); next }
{
  for (i = 1; i <= conditions; i++) if (!holds(i)) next
  if (of != "" && !fits()) next
  k = ""
  for (i = 1; i <= keys; i++) k = k SUBSEP (number($key[i]) ? sprintf("%.7g", $key[i]) : $key[i])
  k = k SUBSEP (++times[tables, k])
  if (tables == 1) order[++rows] = k
  else if (found[k] != tables - 1) next
  row[k] = row[k] (tables > 1 ? OFS : "") $0; found[k] = tables
}
function put(   i, x) {
  for (i = 1; i <= names; i++) {
    if (bin > 1) x = name[i] in bad ? "nan" : sprintf("%.10g", name[i] ~ /_err(_[0-9]+)?$/ ? sqrt(sum[i]) / bin : sum[i] / bin)
    printf "%s%s", (bin > 1 ? x : field[i]), (i < names ? OFS : "\n")
    sum[i] = 0; delete bad[name[i]]
  }
}
END {
  if (failed) exit 1
  if (!bin) bin = 1
  if (!named) fail("no table")
  for (i = 1; i <= names; i++) if (get == name[i]) wanted = i
  if (get != "" && !wanted) fail("no column " get)
  if (get == "") for (i = 1; i <= names; i++) printf "%s%s", name[i], (i < names ? OFS : "\n")
  for (r = 1; r <= rows; r++) if (found[order[r]] == tables) {
    split(row[order[r]], field, OFS)
    if (get != "") { printf "%s%s", (got++ ? " " : ""), field[wanted]; continue }
    if (bin > 1) for (i = 1; i <= names; i++) {
      if (!number(field[i])) bad[name[i]]
      sum[i] += name[i] ~ /_err(_[0-9]+)?$/ ? field[i] * field[i] : field[i]
    }
    if (++taken % bin == 0) put()
  }
  if (get != "" && !got) fail("no row for " where)
  if (get != "") print ""
}
