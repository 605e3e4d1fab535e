# figures/discs.awk: circles of a pack in 2-D with their images over the sides: x y r
/Lattice=/ { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), L, " "); next }
NR > 2 {
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    x = $2 + i * L[1]; y = $3 + j * L[5]
    if (x > -$5 && x < L[1] + $5 && y > -$5 && y < L[5] + $5) print x "\t" y "\t" $5
  }
}
