# figures/tools/discs.awk, after colour.awk and pack.awk: discs of a pack in their box, with their images over the sides.
FNR == 3 { print "window", 0, 0, X, Y }
FNR > 2 {
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    u = x + i * X; v = y + j * Y
    if (u > -r && u < X + r && v > -r && v < Y + r) { print "disc", "0072b2", u, v, r; print "disc", "c4e5f7", u, v, r - 0.07 }
  }
}
END { frame("777777", 0, 0, X, Y, 1.2) }
