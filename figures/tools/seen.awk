# figures/tools/seen.awk: depth x y r ..., the nearest first -> those of which something may be seen. A sphere covers the squares of a raster
# that lie in its disc wholly, and is seen if its disc reaches into a square that is not covered: nothing that is seen is left out.
BEGIN { OFS = "\t"; fine = 12 }
function ceil(v) { return -floor(-v) }
function floor(v,   i) { i = int(v); return i > v ? i - 1 : i }
# Half the width of a disc of radius r on the line at a distance h from its middle.
function half(r, h) { return h < r ? sqrt(r * r - h * h) : -1 }
{
  x = fine * $2 + 1e5; y = fine * $3; r = fine * $4; seen = 0
  for (j = floor(y - r); j < y + r; j++) {
    near = j > y ? j - y : j + 1 < y ? y - j - 1 : 0; # of the row from the middle
    w = half(r, near)
    for (i = floor(x - w); i < x + w && !seen; i++) if (!((i, j) in covered)) seen = 1
    if (seen) break
  }
  if (!seen) next
  print
  for (j = floor(y - r); j < y + r; j++) {
    away = j + 1 - y > y - j ? j + 1 - y : y - j
    w = half(r, away)
    if (w > 0) for (i = ceil(x - w); i + 1 <= x + w; i++) covered[i, j]
  }
}
