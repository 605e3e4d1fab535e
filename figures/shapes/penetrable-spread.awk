# from: penetrable-scaled/sweep.tsv
# penetrable-spread.awk: the spread over packs of the exposed perimeter, by the area of the box, of each road: spread@ROAD, mean@ROAD and, over that of the
# first road, ratio@ROAD. A perimeter is told by the radius of its own pack, so it is divided by the factor that the radii were scaled by.
BEGIN { FS = "\t"; print "# written by penetrable-spread.awk\nquantity\tvalue\tstandard_error" }
/^#/ { next }
!head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
{
  road = $at["make.road"]; if (!(road in packs)) order[++roads] = road
  x = $at["exposed_perimeter"] / (road == "scale" ? $at["scaled"] : 1)
  packs[road]++; sum[road] += x; square[road] += x * x
}
END {
  for (i = 1; i <= roads; i++) {
    road = order[i]; n = packs[road]; m = sum[road] / n; s[i] = sqrt((square[road] - n * m * m) / (n - 1))
    printf "mean@%s\t%.12g\t%.12g\nspread@%s\t%.12g\t%.12g\n", road, m, s[i] / sqrt(n), road, s[i], s[i] / sqrt(2 * (n - 1))
    if (i > 1) printf "ratio@%s\t%.12g\t%.12g\n", road, s[i] / s[1], s[i] / s[1] / sqrt(n - 1)
  }
  if (roads < 2) { print "penetrable-spread.awk: nothing to compare" > "/dev/stderr"; exit 1 }
}
