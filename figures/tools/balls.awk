# figures/tools/balls.awk, after colour.awk: depth x y r NAME, the farthest first -> what paint.awk draws, each ball with its light, far ones in
# the fog. The option `colours` has NAME RIM TOP NAME RIM TOP ...
BEGIN {
  FS = "\t"; levels = 15
  for (i = split(colours, c, " "); i > 0; i -= 3) { rim[c[i - 2]] = c[i - 1]; top[c[i - 2]] = c[i] }
}
{
  depth[NR] = $1; x[NR] = $2; y[NR] = $3; r[NR] = $4; name[NR] = $5
  if (NR == 1 || x[NR] - r[NR] < left) left = x[NR] - r[NR]
  if (NR == 1 || x[NR] + r[NR] > right) right = x[NR] + r[NR]
  if (NR == 1 || y[NR] - r[NR] < low) low = y[NR] - r[NR]
  if (NR == 1 || y[NR] + r[NR] > high) high = y[NR] + r[NR]
}
END {
  if (!NR) exit
  print "window", left, low, right, high
  for (i = 1; i <= NR; i++) {
    level = int(levels * (depth[i] - depth[1]) / (depth[NR] - depth[1] + 1e-9)); looks[i] = "B" name[i] "x" level
    if (!lit[looks[i]]++) print "light", looks[i], rim[name[i]], mixed(rim[name[i]], top[name[i]], 0.35 + 0.65 * level / (levels - 1))
  }
  for (i = 1; i <= NR; i++) print "ball", looks[i], x[i], y[i], r[i]
}
