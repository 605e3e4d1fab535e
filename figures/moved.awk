# figures/moved.awk: discs of two files of one pack with their images over the sides: x y r, and the way from the first
FNR == 1 { file++; next }
/Lattice=/ { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9, RLENGTH - 9), L, " "); next }
file == 1 { n++; x0[n] = $2; y0[n] = $3; next }
{
  k++
  dx = $2 - x0[k]; dx -= L[1] * int(dx / L[1] + (dx < 0 ? -0.5 : 0.5))
  dy = $3 - y0[k]; dy -= L[5] * int(dy / L[5] + (dy < 0 ? -0.5 : 0.5))
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    x = $2 + i * L[1]; y = $3 + j * L[5]
    if (x > -1.6 * $5 && x < L[1] + 1.6 * $5 && y > -1.6 * $5 && y < L[5] + 1.6 * $5)
      print x "\t" y "\t" $5 "\t" dx "\t" dy
  }
}
