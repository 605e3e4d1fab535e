# from: percolation-turned/sweep.tsv percolation-parallel/sweep.tsv percolation-discs/sweep.tsv
# percolation-threshold.awk: where the line through R_1 of three fractions, by least squares with the errors of the R_1, crosses the value that it has at the
# threshold of a large system: threshold@KIND@SIDE, of the two boxes.
BEGIN { FS = "\t"; R = 0.521058290; print "# written by percolation-threshold.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { head = 0; kind = FILENAME; sub(/\/.*/, "", kind); sub(/.*-/, "", kind) }
/^#/ { next }
!head { delete at; for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{
  key = kind "@" $at["side"]; if (!(key in n)) order[++keys] = key
  x = $at["fraction"]; y = $at["percolates_x"]; p = (y * 200 + 1) / 202; w = 1 / (p * (1 - p))
  n[key]++; S[key] += w; X[key] += w * x; Y[key] += w * y; XX[key] += w * x * x; XY[key] += w * x * y
  packs = $at["realizations"]
}
END {
  for (i = 1; i <= keys; i++) {
    key = order[i]; D = S[key] * XX[key] - X[key] ^ 2; b = (S[key] * XY[key] - X[key] * Y[key]) / D; m = X[key] / S[key]
    a = Y[key] / S[key] + b * (0 - m); t = (R - a) / b; v = 1 / S[key] + (t - m) ^ 2 * S[key] / D
    printf "threshold@%s\t%.12g\t%.12g\n", key, t, sqrt(v / packs) / b
  }
  if (!keys) { print "percolation-threshold.awk: nothing to fit" > "/dev/stderr"; exit 1 }
}
