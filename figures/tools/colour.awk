# figures/tools/colour.awk: colours as rrggbb, for the programs that follow it with -f.
function hex(v) { v = int(v + 0.5); return substr("0123456789abcdef", int(v / 16) + 1, 1) substr("0123456789abcdef", v % 16 + 1, 1) }
function byte(c, i) { return 16 * index("123456789abcdef", substr(c, i, 1)) + index("123456789abcdef", substr(c, i + 1, 1)) }
function mixed(a, b, f,   i, c) {
  for (i = 1; i < 6; i += 2) c = c hex(byte(a, i) + f * (byte(b, i) - byte(a, i)))
  return c
}
# The colour at t, 0 to 1, of a palette: places and colours in turn.
function shade(palette, t,   stop, i) {
  t = t < 0 ? 0 : t > 1 ? 1 : t
  for (i = split(palette, stop, " ") - 3; i > 1 && stop[i] > t; i -= 2) { }
  return mixed(stop[i + 1], stop[i + 3], (t - stop[i]) / (stop[i + 2] - stop[i]))
}
# A bar of the palette, in fifty boxes for paint.awk, along x or along y.
function bar(palette, x0, y0, x1, y1, along,   i, f) {
  for (i = 0; i < 50; i++) {
    f = i / 50
    if (along == "x") print "box", shade(palette, f + 0.01), x0 + f * (x1 - x0), y0, x1, y1
    else print "box", shade(palette, f + 0.01), x0, y0 + f * (y1 - y0), x1, y1
  }
}
function frame(c, x0, y0, x1, y1, w) {
  print "line", c, x0, y0, x1, y0, w; print "line", c, x1, y0, x1, y1, w; print "line", c, x1, y1, x0, y1, w; print "line", c, x0, y1, x0, y0, w
}
BEGIN { OFS = "\t" }
