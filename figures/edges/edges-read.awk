# from: edges-torus/{K,rdf}.tsv edges-points/{K,rdf}@*.tsv edges-beads/{K,rdf}@*.tsv edges-torus/summary.tsv edges-points/summary.tsv edges-beads/summary.tsv edges-shapes-torus/{K,summary}.tsv edges-shapes/K@*.tsv edges-shapes/summary.tsv
# edges-read.awk: what windows make of K, of g and of the contact value, by what is true: of points known, of beads that of the tori.
# Q_bias@PACKS@SIDE@EDGES: the mean over packs by the truth, less 1; Q_sd: the standard deviation of one pack by the truth. Q is K at
# R = 3, g (the mean over the bin that ends there), contact or first (the bin 2 to 2.01). law@Q@EDGES: the mean of sd sqrt(N) over
# the sides, of beads; aste@Q: that of 150 000 beads; for@Q: how many beads have a standard deviation of one per cent, by Ripley's; fifth@first: how many see a fifth of the first bin as three
# standard deviations. none@PACKS@SIDE: K_bias if nothing is done about the edge, from the truth and the mean overlap of a cube.
# shape_bias@SHAPE@EDGES, shape_sd: of K at R = 5 in the shapes, per cent. number@PACKS@SIDE, number_shape@SHAPE: N. fano@PACKS@SIDE: variance of N
# by its mean; predicted@beads@SIDE: the bias of K that follows, and that of the tori. dir/edges.tsv: the same for the figure.
function row(name, value, error) { printf "%s\t%.12g\t%.12g\n", name, value, error }
function volume(r) { return 4 / 3 * 3.14159265358979 * r ^ 3 }
function note(q, packs, at, edges, value, error, truth, slip, n,   sd) {
  sd = error * sqrt(n) / truth
  bias[q, packs, at, edges] = value / truth - 1; bias_err[q, packs, at, edges] = sqrt((error / truth) ^ 2 + (slip * value / truth ^ 2) ^ 2)
  dev[q, packs, at, edges] = sd; dev_err[q, packs, at, edges] = sd / sqrt(2 * (n - 1))
}
BEGIN { FS = "\t"; print "# written by edges-read.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 {
  head = 0; split(FILENAME, path, "/"); scene = path[1]; file = path[2]; sub(/\.tsv$/, "", file)
  parts = split(file, part, "@"); packs = scene; sub(/^edges-/, "", packs)
}
/^# scene/ { match($0, /packs [0-9]+/); n = substr($0, RSTART + 6, RLENGTH - 6) }
/^#/ { next }
!head { delete col; for (k = 1; k <= NF; k++) col[$k] = k; head = 1; next }
# A line of a table: R, and its function with the error.
part[1] == "K" || part[1] == "rdf" { q = part[1] == "K" ? "K" : "g"; R = $col["R"] + 0; v = $col[q]; e = $col[q "_err"] }
part[1] == "K" {
  of[packs] = n # that of a summary is all combinations
  if (scene ~ /torus$/) { true_K[scene, R] = v; err_K[scene, R] = e; next }
  if (packs == "shapes" && R == 5) note("shape", "shapes", part[2], part[3], v, e, true_K["edges-shapes-torus", 5], 0, n)
  else if (R == 3 && packs == "points") note("K", packs, part[2], part[3], v, e, volume(3), 0, n)
  else if (R == 3) note("K", packs, part[2], part[3], v, e, true_K["edges-torus", 3], err_K["edges-torus", 3], n)
  next
}
part[1] == "rdf" && R > 2.85 && R < 2.95 {
  if (scene ~ /torus$/) { true_g = v; err_g = e }
  else if (packs == "points") note("g", packs, part[2], part[3], v, e, 1, 0, n)
  else note("g", packs, part[2], part[3], v, e, true_g, err_g, n)
}
file == "summary" {
  q = $1; parts = split(q, part, "@")
  if (scene ~ /torus$/) { truth[scene, q] = $2; slip[scene, q] = $3; next }
  if (part[1] == "centres") { number[packs, part[2]] = $2; fano[packs, part[2]] = $3 ^ 2 * of[packs] / $2; if (!((packs, part[2]) in there)) { there[packs, part[2]]; at[packs, ++sides[packs]] = part[2] } }
  name = part[1] == "contact_first_bin" ? "first" : part[1]
  if (part[1] == "contact" || part[1] == "contact_first_bin") {
    torus = packs == "shapes" ? "edges-shapes-torus" : "edges-torus"
    note(name, packs, part[2], part[3], $2, $3, truth[torus, part[1]], slip[torus, part[1]], of[packs])
  }
}
# K at R = 3 in a cube of this side if nothing is done.
function nothing(packs, s,   r, sum, more, all) {
  for (r = 0.2; r < 3.1; r += 0.2) {
    more = packs == "points" ? volume(r) - volume(r - 0.2) : true_K["edges-torus", sprintf("%.1f", r) + 0] - (r > 0.3 ? true_K["edges-torus", sprintf("%.1f", r - 0.2) + 0] : 0)
    u = (r - 0.1) / s; all += more; sum += more * (1 - 1.5 * u + 2 / 3.14159265358979 * u ^ 2 - u ^ 3 / (4 * 3.14159265358979))
  }
  return sum / all - 1
}
END {
  words = split("minus ripley translation", way, " "); kinds = split("points beads", kind, " "); quantities = split("K g contact first", quantity, " ")
  print "packs\tside\tedges\tN\tone\tK\tK_err\tK_sd\tK_sd_err\tg\tg_err\tg_sd\tg_sd_err\tcontact\tcontact_err\tcontact_sd\tcontact_sd_err\tnone" > (dir "/edges.tsv")
  for (p = 1; p <= kinds; p++) for (i = 1; i <= sides[kind[p]]; i++) {
    s = at[kind[p], i]; N = number[kind[p], s]
    row("number@" kind[p] "@" s, sprintf("%.0f", N), 0); row("none@" kind[p] "@" s, sprintf("%.2f", nothing(kind[p], s)), 0)
    F = fano[kind[p], s]; row("fano@" kind[p] "@" s, F, F * sqrt(2 / (of[kind[p]] - 1)))
    if (kind[p] == "beads") row("predicted@beads@" s, (1 - F) / N - 1 / truth["edges-torus", "number"], F * sqrt(2 / (of[kind[p]] - 1)) / N)
    for (w = 1; w <= words; w++) {
      printf "%s\t%s\t%s\t%.6g\t%.6g", kind[p], s, way[w], N, 1 / N > (dir "/edges.tsv")
      for (q = 1; q <= quantities; q++) {
        key = quantity[q] SUBSEP kind[p] SUBSEP s SUBSEP way[w]; name = "@" kind[p] "@" s "@" way[w]
        if (q < 4 && !(key in bias)) printf "\tnan\tnan\tnan\tnan" > (dir "/edges.tsv")
        if (!(key in bias)) continue
        if (q < 4) printf "\t%.6g\t%.3g\t%.6g\t%.3g", bias[key], bias_err[key], dev[key], dev_err[key] > (dir "/edges.tsv")
        row(quantity[q] "_bias" name, bias[key], bias_err[key]); row(quantity[q] "_sd" name, dev[key], dev_err[key])
        if (kind[p] == "beads") { law[q, w] += dev[key] * sqrt(N) / sides["beads"]; law_err[q, w] += (dev_err[key] * sqrt(N) / sides["beads"]) ^ 2 }
      }
      printf "\t%.6g\n", nothing(kind[p], s) > (dir "/edges.tsv")
    }
  }
  for (q = 1; q <= quantities; q++) for (w = 1; w <= words; w++) row("law@" quantity[q] "@" way[w], law[q, w], sqrt(law_err[q, w]))
  for (q = 1; q <= quantities; q++) row("aste@" quantity[q], law[q, 2] / sqrt(150000), sqrt(law_err[q, 2] / 150000))
  for (q = 1; q <= quantities; q++) { c = law[q, 2]; row("for@" quantity[q], (100 * c) ^ 2, 20000 * c * sqrt(law_err[q, 2])) }
  c = law[4, 2]; row("fifth@first", (15 * c) ^ 2, 450 * c * sqrt(law_err[4, 2]))
  for (i = 1; i <= sides["shapes"]; i++) {
    s = at["shapes", i]; row("number_shape@" s, sprintf("%.0f", number["shapes", s]), 0)
    for (w = 1; w <= words; w++) {
      key = "shapes" SUBSEP s SUBSEP way[w]
      row("shape_bias@" s "@" way[w], 100 * bias["shape", key], 100 * bias_err["shape", key]); row("shape_sd@" s "@" way[w], 100 * dev["shape", key], 100 * dev_err["shape", key])
    }
  }
}
