# from: pack-grown/pack-?.xyz gravity-touch/pack-?.xyz
# touch.awk: counts in saved packs of equal spheres of radius 1. lonely: the share of particles with fewer than two contacts,
# gaps to a millionth of a diameter, in the core of packs by gravity (within .6 of the radius of a pack), over the packs. beyond: of a
# periodic pack, the share of moves that end in an overlap if (9) is taken by the letter: along each of 26 directions a move is uniform from 0 to
# the largest of the ways to the spheres that are met within the testing window of 2.02, at most .02.
function cellof(x, c) { c = int(x / width); return c < 0 ? 0 : c >= cells ? cells - 1 : c }
function wrap(c) { return open ? c : (c + cells) % cells }
function store(   i, key) {
  delete list; width = open ? 2.1 : side / int(side / 2.1); cells = int(side / width + 1e-9)
  for (i = 1; i <= n; i++) { key = cellof(x[i]) " " cellof(y[i]) " " cellof(z[i]); list[key] = list[key] " " i }
}
# The spheres within reach of i: near[1..], at dx, dy, dz from it.
function neighbours(i, reach,   a, b, c, p, q, r, m, k, part, u, v, w) {
  found = 0; p = cellof(x[i]); q = cellof(y[i]); r = cellof(z[i])
  for (a = p - 1; a <= p + 1; a++) for (b = q - 1; b <= q + 1; b++) for (c = r - 1; c <= r + 1; c++) {
    m = split(list[wrap(a) " " wrap(b) " " wrap(c)], part, " ")
    for (k = 1; k <= m; k++) if (part[k] != i) {
      u = image(x[part[k]] - x[i]); v = image(y[part[k]] - y[i]); w = image(z[part[k]] - z[i])
      if (u * u + v * v + w * w <= reach * reach) { found++; dx[found] = u; dy[found] = v; dz[found] = w }
    }
  }
}
function image(d) { return open ? d : d > side / 2 ? d - side : d < -side / 2 ? d + side : d }
function lonely(   i, few, all) {
  for (i = 1; i <= n; i++) {
    if ((x[i] - side / 2) ^ 2 + (y[i] - side / 2) ^ 2 + (z[i] - side / 2) ^ 2 > (0.6 * open) ^ 2) continue
    neighbours(i, 2 + 2e-6); all++; few += found < 2
  }
  packs++; sum += few / all; square += (few / all) ^ 2
}
function least(a, b) { return a < b ? a : b }
function beyond(   i, k, u, v, w, s, b, t, first, last, bad, all) {
  for (i = 1; i <= n; i++) {
    neighbours(i, 2.02)
    for (u = -1; u <= 1; u++) for (v = -1; v <= 1; v++) for (w = -1; w <= 1; w++) {
      if (!(s = sqrt(u * u + v * v + w * w))) continue
      first = 1e300; last = 0
      for (k = 1; k <= found; k++) {
        b = (u * dx[k] + v * dy[k] + w * dz[k]) / s; t = b * b - (dx[k] ^ 2 + dy[k] ^ 2 + dz[k] ^ 2 - 4)
        if (b <= 0 || t < 0) continue
        t = b - sqrt(t); first = least(first, t); if (t > last) last = t
      }
      all++; if (last > 0) bad += 1 - least(first, 0.02) / least(last, 0.02)
    }
  }
  printf "beyond\t%.12g\t0\n", bad / all
}
function use() { if (!n) return; store(); if (open) lonely(); else beyond() }
BEGIN { print "# written by touch.awk\nquantity\tvalue\tstandard_error" }
FNR == 1 { use(); n = 0; next }
FNR == 2 { open = match($0, / open=[0-9.]+/) ? substr($0, RSTART + 6, RLENGTH - 6) + 0 : 0; side = $0; sub(/^Lattice="/, "", side); side += 0; next }
{ n++; x[n] = $2; y[n] = $3; z[n] = $4 }
END { use(); sum /= packs; square = square / packs - sum * sum
  printf "lonely\t%.12g\t%s\n", sum, (packs > 1 ? sprintf("%.12g", sqrt((square > 0 ? square : 0) / (packs - 1))) : "nan") }
