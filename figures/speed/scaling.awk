# from: unimodal-peaks/summary.tsv rsa-saturation-3d/summary.tsv relax-pentagons/summary.tsv
# scaling.awk: how much the work of realizations differs, spread_* in percent, from the errors of counts; and the efficiency in percent,
# when 32000 realizations are dealt out to the 32 workers of each of so many nodes as they come free (dealt@SPREAD@NODES), or
# given out beforehand by their numbers (fixed@SPREAD@NODES).
BEGIN { FS = "\t"; print "# written by scaling.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { n = split(FILENAME, path, "/"); scene = path[n - 1] }
{ value[scene, $1] = $2; error[scene, $1] = $3 }
function spread(name, scene, row, packs,   count) {
  count = value[scene, packs]
  if (value[scene, row] > 0 && count > 1)
    printf "spread_%s\t%.2g\t0\n", name, 100 * error[scene, row] * sqrt(count) / value[scene, row]
}
function uniform() { seed = seed * 16807 % 2147483647; return seed / 2147483647 }
function drawn(s,   i, sum) { # of mean 1 and this standard deviation, nearly normal
  for (i = sum = 0; i < 12; i++) sum += uniform()
  sum = 1 + s * (sum - 6)
  return sum > 0.05 ? sum : 0.05
}
function sink(i, n,   j, t) { # end[1] is the earliest: it goes down to its place
  for (; (j = 2 * i) <= n; i = j) {
    if (j < n && end[j + 1] < end[j]) j++
    if (end[i] <= end[j]) return
    t = end[i]; end[i] = end[j]; end[j] = t
  }
}
function deal(s, nodes,   workers, jobs, k, w, sum, last, most) {
  workers = 32 * nodes; jobs = 32000; seed = 77
  for (w = 1; w <= workers; w++) end[w] = fixed[w] = 0
  for (k = sum = last = 0; k < jobs; k++) {
    w = drawn(s); sum += w
    fixed[k % workers + 1] += w
    end[1] += w
    if (end[1] > last) last = end[1]
    sink(1, workers)
  }
  for (w = 1; w <= workers; w++) if (fixed[w] > most) most = fixed[w]
  printf "dealt@%s@%d\t%.1f\t0\nfixed@%s@%d\t%.1f\t0\n", s, nodes, 100 * sum / (workers * last), s, nodes, 100 * sum / (workers * most)
}
END {
  spread("grown", "unimodal-peaks", "collisions@retry@10@0.6", "realizations@retry@10@0.6")
  spread("saturated", "rsa-saturation-3d", "trials", "realizations")
  spread("relaxed", "relax-pentagons", "relax_steps@dynamics@0.8", "realizations@dynamics@0.8")
  for (nodes = 1; nodes <= 1000; nodes *= 10) { deal(0.02, nodes); deal(0.1, nodes); deal(0.5, nodes) }
}
