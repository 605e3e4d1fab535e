# figures/light.awk: depth x y r species, far first -> x y r light species: a dark rim, then discs that
# shrink towards the light at the upper left, seven or as many as a sixth column says.
BEGIN { FS = OFS = "\t" }
{
  fog = ($1 + 22) / 44; fog = fog < 0 ? 0 : fog > 1 ? 1 : fog
  print $2, $3, $4, 0, $5
  discs = NF > 5 ? $6 : 7
  for (k = 1; k <= discs; k++) {
    q = k / discs
    print $2 - 0.33 * $4 * q, $3 + 0.36 * $4 * q, $4 * 0.97 * (1 - 0.88 * q), q * q * (0.35 + 0.65 * fog), $5
  }
}
