# from: relax-dense/sweep.tsv relax-literal/sweep.tsv
# relax-rate.awk: how many of the seeds of a sweep were freed of overlap, of how many, and the means over these: freed@KEY, packs@KEY, steps@KEY,
# order@KEY. KEY is dense, and for S's equations as printed the coefficient of friction.
BEGIN { FS = "\t"; print "# written by relax-rate.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { head = 0; dense = FILENAME ~ /dense/ }
/^#/ { next }
!head { delete at; for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{
  key = dense ? "dense" : $at["make.friction"]; if (!(key in packs)) order[++keys] = key
  packs[key]++
  if ($at["reached"] == 1) { freed[key]++; add(key, "steps", $at["relax_steps"]); add(key, "order", $at["Q6_local"]) }
}
function add(key, what, x) { sum[key, what] += x; square[key, what] += x * x }
function mean(key, what,   n, m) {
  n = freed[key]; m = sum[key, what] / n
  printf "%s@%s\t%.12g\t%s\n", what, key, m, (n > 1 ? sprintf("%.12g", sqrt((square[key, what] / n - m * m) / (n - 1))) : "nan")
}
END {
  for (i = 1; i <= keys; i++) {
    key = order[i]; printf "freed@%s\t%d\t0\npacks@%s\t%d\t0\n", key, freed[key], key, packs[key]
    if (freed[key]) { mean(key, "steps"); mean(key, "order") }
  }
  if (!keys) { print "relax-rate.awk: nothing to count" > "/dev/stderr"; exit 1 }
}
