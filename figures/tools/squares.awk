# figures/tools/squares.awk, after colour.awk: what cut.awk has of two packs, as squares side by side, without a contact lighter.
BEGIN {
  FS = "\t"; apart = 2 * half + 5; split("coarse discs added;coarse discs marked", name, ";")
  print "window", -half, -half - 5, apart + half, half
}
function finish() {
  frame("777777", middle - half, -half, middle + half, half, 1); print "clip"
  print "words", middle, -half - 3, name[pack]
}
FNR == 1 { if (pack) finish(); middle = apart * pack++; print "clip", middle - half, -half, middle + half, half }
{
  fine = $4 == 1
  print "disc", (fine ? "0072b2" : "8a3c00"), $1 + middle, $2, $3
  print "disc", ($5 < 1e-6 ? (fine ? "8cc8ec" : "e07b28") : fine ? "ffffff" : "fbe3d0"), $1 + middle, $2, $3 - 0.07
}
END { finish() }
