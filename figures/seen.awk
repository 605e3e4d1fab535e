# figures/seen.awk: depth x y r ..., near first -> those of which something is seen, on a raster of twenty points a unit: what is
# behind all others need not be drawn.
{
  seen = 0
  for (i = int(20 * ($2 - $4)); i <= 20 * ($2 + $4); i++) {
    h = $4 ^ 2 - (i / 20 - $2) ^ 2
    if (h < 0) continue
    h = sqrt(h)
    for (j = int(20 * ($3 - h)); j <= 20 * ($3 + h); j++) if (!((i, j) in full)) { full[i, j]; seen = 1 }
  }
  if (seen) print
}
