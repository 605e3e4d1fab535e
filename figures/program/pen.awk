# figures/program/pen.awk, after colour.awk: what the pictures of the program draw with, as rows for paint.awk; the option `width` is that of paint.awk.
BEGIN { pi = 3.14159265358979; OFS = "\t"; blue = "0072b2"; light = "c4e5f7"; brown = "8a4b08"; cream = "f6d9b8"; red = "d55e00"; grey = "777777"; green = "009e73"; black = "000000" }
# The window; from then on a point, as of lines, is so many units of the drawing.
function window(x0, y0, x1, y1) { print "window", x0, y0, x1, y1; point = (x1 - x0) / (width * 28.3465) }
function disc(fill, rim, x, y, r) { print "disc", rim, x, y, r; print "disc", fill, x, y, r - 0.7 * point }
# A disc with its images that reach into the box from 0 to X, Y.
function tiled(fill, rim, x, y, r,   i, j, u, v) {
  for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
    u = x + i * X; v = y + j * Y
    if (u > -r && u < X + r && v > -r && v < Y + r) disc(fill, rim, u, v, r)
  }
}
function line(c, x0, y0, x1, y1, w) { print "line", c, x0, y0, x1, y1, w }
function ring(c, x, y, r, w) { print "ring", c, x, y, r, w }
function arc(c, x, y, r, from, to, w) { print "arc", c, x, y, r, from, to, w }
function dot(c, x, y, points) { print "disc", c, x, y, points * point }
function dash(on, off) { if (on) print "dash", on, off; else print "dash" }
function words(x, y, s, how) { print "words", x, y, "\\small " s, how }
function arrow(c, x0, y0, x1, y1, w,   d, a, b, h) {
  d = sqrt((x1 - x0) ^ 2 + (y1 - y0) ^ 2); if (d == 0) return
  a = (x1 - x0) / d; b = (y1 - y0) / d; h = (3 + w) * point; if (h > 0.6 * d) h = 0.6 * d
  line(c, x0, y0, x1 - 0.7 * h * a, y1 - 0.7 * h * b, w)
  print "path", c, c, 0.2, x1, y1, x1 - h * a - 0.4 * h * b, y1 - h * b + 0.4 * h * a, x1 - h * a + 0.4 * h * b, y1 - h * b - 0.4 * h * a
}
function nearest(d, side) { return d - side * int(d / side + (d < 0 ? -0.5 : 0.5)) }
function angle(y, x,   t) { t = atan2(y, x); return t < 0 ? t + 2 * pi : t }
function fail(why) { print "a picture of the program: " why > "/dev/stderr"; failed = 1; exit 1 }
