# figures/tools/diluted.awk, after colour.awk: what cut.awk has of three packs, side by side, coloured by the gap, with a bar below. The
# option `moves` has the length of the moves of each.
BEGIN { FS = "\t"; split(moves, longest, " "); rim = 43; palette = "0 08306b 0.25 2171b5 0.6 8cc0e0 1 d3e4f2"; print "window", -rim, -72, 5 * rim, rim }
FNR == 1 { pack++ }
{ print "disc", shade(palette, $5 / 0.4), $1 + 2 * rim * (pack - 1), $2, $3 }
END {
  for (k = 1; k <= 3; k++) print "words", 2 * rim * (k - 1), -48, (longest[k] > 0 ? sprintf("moves up to $%.2f\\,a$", longest[k]) : "no moves")
  bar(palette, 50, -59, 122, -56, "x")
  for (k = 0; k <= 4; k++) print "words", 50 + 18 * k, -62.5, k ? "." k : "0"
  print "words", 86, -69, "distance of the nearest surface, in diameters"
}
