# from: s3-squares/S3.tsv s3-homometric/S3@first.tsv s3-homometric/S3@second.tsv
# s3-limits.awk: what S says of its Fig. 10, from the table of squares: limits, edges, the diagonal; and how far three points, and two, tell the
# two homometric packs apart, in standard errors.
BEGIN { FS = "\t"; print "# written by s3-limits.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { table++; head = 0 }
/^#/ { next }
!head { delete at; for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{
  i = sprintf("%.0f", $at["R1"] * 10); j = sprintf("%.0f", $at["R2"] * 10); key = table SUBSEP $at["theta"] + 0 SUBSEP i SUBSEP j
  S[key] = $at["S3"]; error[key] = $at["S3_err"]; if (i + 0 > most[table]) most[table] = i + 0
}
function s(theta, i, j) { return S[1, theta, i, j] }
function say(name, value, e) { printf "%s\t%.12g\t%.12g\n", name, value, e }
function cell(name, theta, i, j) { say(name, s(theta, i, j), error[1, theta, i, j]) }
function absolute(x) { return x < 0 ? -x : x }
# How far the surface falls from the diagonal within so many steps, a mean from R = 1 to 5.
function ridge(step,   i, n, sum) { for (i = 10; i <= 50; i++) { n++; sum += s(0, i, i) - s(0, i, i + step) } return sum / n }
# In standard errors, the most by which the packs differ on an edge, and at the corners of P's triangle.
function apart(i, j,   a, b) {
  a = 2 SUBSEP 90 SUBSEP i SUBSEP j; b = 3 SUBSEP 90 SUBSEP i SUBSEP j
  return (S[a] - S[b]) / sqrt(error[a] ^ 2 + error[b] ^ 2 + 1e-30)
}
END {
  n = most[1]
  if (n != 60 || most[2] != 40 || most[3] != 40) { print "s3-limits.awk: not the tables that were meant" > "/dev/stderr"; exit 1 }
  cell("corner", 0, 0, 0); cell("diagonal_far", 0, n, n); cell("edge_far", 60, 0, n); cell("far", 60, n, n); cell("one_far", 60, 10, n)
  say("one_far_two", s(0, 0, 0) * s(60, 0, 10), s(0, 0, 0) * error[1, 60, 0, 10])
  for (i = 0; i <= n; i++) {
    if (absolute(s(0, i, i) - s(0, 0, i)) > off) off = absolute(s(0, i, i) - s(0, 0, i))
    if (i && (d = absolute(s(10, 0, i) - s(10, i, 0)) / sqrt(error[1, 10, 0, i] ^ 2 + error[1, 10, i, 0] ^ 2)) > edges) edges = d
  }
  say("diagonal_off", off, 0); say("edges_off", edges, 0)
  say("steepness", (s(0, 0, 0) - s(0, 1, 1)) / sqrt(2) / (s(0, 0, 0) - s(0, 0, 1)), 0)
  say("ridge", ridge(1), 0); say("ridge_wide", ridge(2), 0); say("ridge_ratio", ridge(2) / ridge(1), 0)
  say("one_order", 1 - 2 * s(0, 0, 0) + 2 * s(60, 0, n), 0)
  for (i = 1; i <= 40; i++) if (absolute(apart(0, i)) > two) two = absolute(apart(0, i))
  say("twins_two", two, 0); say("twins_three", apart(21, 21), 0)
  say("twins_first", S[2, 90, 21, 21], error[2, 90, 21, 21]); say("twins_second", S[3, 90, 21, 21], error[3, 90, 21, 21])
}
