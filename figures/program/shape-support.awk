# figures/program/shape-support.awk, after pen.awk and pack.awk: the superellipses of a pack, each with a line of its support and with a point, through which the shape goes when
# it is scaled by the gauge.
function power(v, p) { return v == 0 ? 0 : (v < 0 ? -v : v) ^ p }
function sign(v) { return v < 0 ? -1 : 1 }
FNR > 2 { N = particle; name[N] = $place["species"]; tx[N] = cos($place["angle"]); ty[N] = sin($place["angle"]) }
function put(x, y) { px = ox + x; py = oy + y }
END {
  window(-2.25, -2.2, 15.4, 1.6); oy = 0
  for (i = 1; i <= N; i++) {
    match(head, "shape_" name[i] "=\"[^\"]*\""); split(substr(head, RSTART, RLENGTH - 1), part, ":"); m = part[3]; ox = 4.5 * (i - 1); p = 2 * m
    # The axes of area pi, by a polygon with nodes that are dense at the corners.
    area = 0; a = part[2]; b = 1; K = m > 1 && m < 9 ? 48 : m >= 9 ? 96 : m < 1 ? 4 : 48
    for (k = 0; k <= 2000; k++) { t = 2 * pi * k / 2000; u = a * sign(cos(t)) * power(cos(t), 1 / m); v = b * sign(sin(t)) * power(sin(t), 1 / m); if (k) area += (u0 * v - u * v0) / 2; u0 = u; v0 = v }
    f = sqrt(pi / area); a *= f; b *= f
    # The direction of the support, in the frame of the shape, and the point that it touches.
    t = 0.62; nx = cos(t); ny = sin(t)
    if (m == 0.5) { h = a * nx > b * ny ? a * nx : b * ny; sx = a * nx > b * ny ? a : 0; sy = a * nx > b * ny ? 0 : b }
    else { q = p / (p - 1); w = power(a * nx, q) + power(b * ny, q); h = w ^ (1 / q); sx = a * power(a * nx, q / p) / w ^ (1 / p); sy = b * power(b * ny, q / p) / w ^ (1 / p) }
    # The point of the gauge.
    rx = -0.8; ry = 0.85; g = (power(rx / a, p) + power(ry / b, p)) ^ (1 / p)
    row = ""; far = ""
    for (k = 0; k <= K; k++) { t = 2 * pi * (k % K) / K; u = a * sign(cos(t)) * power(cos(t), 1 / m); v = b * sign(sin(t)) * power(sin(t), 1 / m); if (k < K) row = row OFS ox + u OFS oy + v; far = far OFS ox + g * u OFS oy + g * v }
    dash(2, 2); print "curve", brown, 0.8 far; dash()
    print "path", light, blue, 0.8 row
    t = (sy - h * ny) * nx - (sx - h * nx) * ny  # from the foot of the arrow to the point, along the line
    low = t < 0 ? t - 0.5 : -0.5; high = t > 0 ? t + 0.5 : 0.5
    line(red, ox + h * nx - low * ny, oy + h * ny + low * nx, ox + h * nx - high * ny, oy + h * ny + high * nx, 1.2)
    arrow(black, ox, oy, ox + h * nx, oy + h * ny, 0.9); dot(red, ox + sx, oy + sy, 1.9)
    line(grey, ox, oy, ox + rx, oy + ry, 0.6); dot(brown, ox + rx, oy + ry, 1.9); dot(black, ox, oy, 1.3)
    words(ox, -1.9, "$m=" (m == 0.5 ? "\\frac12" : m + 0) "$")
  }
}
