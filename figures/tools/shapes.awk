# figures/tools/shapes.awk, after colour.awk and pack.awk: shapes of a pack in their box, with their images over the sides; of a superellipse
# a polygon of 96 sides, or of so many as `nodes` says. Options: dx, how far to the right it is drawn; joined=1 if the window has been told; fill and rim, of the first
# species and of others, "cfe0f4 0b3f70 f6d9b8 8a4b08"; half: the shapes are seen through, as of penetrable packs.
BEGIN { pi = 3.14159265358979; if (colours == "") colours = "c4e5f7 0072b2 f6d9b8 8a4b08"; split(colours, ink, " ") }
# The corners of a species' shape of radius 1 into cx[name, k], cy[name, k]; corners[name].
function shaped(name, words,   w, k, n, t, c, s, p, a, b, area) {
  split(words, w, ":")
  if (w[1] == "polygon") {
    n = w[2]; a = sqrt(2 * pi / (n * sin(2 * pi / n)))
    for (k = 0; k < n; k++) { cx[name, k] = a * cos(2 * pi * k / n); cy[name, k] = a * sin(2 * pi * k / n) }
  } else if (w[1] == "vertices") {
    n = split(w[2], v, ",") / 2
    for (k = 0; k < n; k++) { cx[name, k] = v[2 * k + 1]; cy[name, k] = v[2 * k + 2] }
    scaled(name, n)
  } else {
    n = nodes ? nodes : 96; p = 1 / w[3]
    for (k = 0; k < n; k++) {
      t = 2 * pi * (k + 0.5) / n; c = cos(t); s = sin(t)
      cx[name, k] = w[2] * (c < 0 ? -1 : 1) * (c < 0 ? -c : c) ^ p; cy[name, k] = (s < 0 ? -1 : 1) * (s < 0 ? -s : s) ^ p
    }
    scaled(name, n)
  }
  corners[name] = n
}
# About the centroid, and of area pi.
function scaled(name, n,   k, j, d, A, X0, Y0) {
  for (k = 0; k < n; k++) {
    j = (k + 1) % n; d = cx[name, k] * cy[name, j] - cx[name, j] * cy[name, k]
    A += d / 2; X0 += (cx[name, k] + cx[name, j]) * d / 6; Y0 += (cy[name, k] + cy[name, j]) * d / 6
  }
  X0 /= A; Y0 /= A; d = sqrt(pi / (A < 0 ? -A : A))
  for (k = 0; k < n; k++) { cx[name, k] = (cx[name, k] - X0) * d; cy[name, k] = (cy[name, k] - Y0) * d }
}
FNR == 3 {
  delete corners; rest = head; forms = 0
  while (match(rest, /shape_[^=]*="[^"]*"/)) {
    word = substr(rest, RSTART, RLENGTH); rest = substr(rest, RSTART + RLENGTH)
    name = word; sub(/^shape_/, "", name); sub(/=.*/, "", name); sub(/^[^"]*"/, "", word); sub(/"$/, "", word); shaped(name, word); names[++forms] = name
  }
  if (!joined && !begun++) print "window", 0, 0, X * (wide ? wide : 1), Y
  for (i = 1; i <= forms; i++) {
    name = names[i]; form[name] = "S" dx + 0 "x" i; at = ""
    for (k = 0; k < corners[name]; k++) at = at "\t" cx[name, k] "\t" cy[name, k]
    print "outline", form[name] at
  }
  print "clip", dx, 0, X + dx, Y
}
FNR > 2 {
  name = $place["species"]; far = 0
  c = cos($place["angle"]); s = sin($place["angle"]); n = corners[name]
  for (k = 0; k < n; k++) { d = r * sqrt(cx[name, k] ^ 2 + cy[name, k] ^ 2); if (d > far) far = d }
  if (!n) far = r
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    u = x + i * X; v = y + j * Y
    if (u < -far || u > X + far || v < -far || v > Y + far) continue
    if (!n) { print "disc", ink[2 * kind], u + dx, v, r; print "disc", ink[2 * kind - 1], u + dx, v, r - 0.004 * X; continue }
    print "shape", form[name], ink[2 * kind - 1], ink[2 * kind], 0.4, u + dx, v, r, c, s
  }
}
END { print "clip"; frame("777777", dx, 0, X + dx, Y, 0.8) }
