# figures/program/core-centres.awk, after pen.awk and pack.awk: a finite pack, its core for a reach, and what one centre of the core has within
# that reach.
FNR > 2 { N = particle; px[N] = x - X / 2; py[N] = y - Y / 2 }
END {
  match(head, /open=[^ ]*/); R = substr(head, RSTART + 5, RLENGTH - 5) + 0
  reach = 5; c = j = 0; window(-R - 0.1, -R - 0.1, R + 0.1, R + 0.1)
  for (k = 1; k <= N; k++) { d = sqrt(px[k] ^ 2 + py[k] ^ 2); if (d < R - reach && d > far) { far = d; c = k } }
  for (pass = 0; pass < 4; pass++) for (k = 1; k <= N; k++) {
    d = sqrt(px[k] ^ 2 + py[k] ^ 2); core = d < R - reach; partner = (px[k] - px[c]) ^ 2 + (py[k] - py[c]) ^ 2 < reach ^ 2
    if (core == pass % 2) print "disc", (pass < 2 ? (core ? blue : "909090") : core ? "a9d3ee" : "ececec"), px[k], py[k], pass < 2 ? 1 : 1 - 0.7 * point
    if (k != c && partner && pass == 3) { held++; mx[held] = px[k]; my[held] = py[k] }
  }
  for (k = 1; k <= held; k++) dot(black, mx[k], my[k], 1.6)
  dash(4, 2); ring(blue, 0, 0, R - reach, 1.1); dash(); ring(black, 0, 0, R, 1); ring(red, px[c], py[c], reach, 1.2); dot(red, px[c], py[c], 2.2)
}
