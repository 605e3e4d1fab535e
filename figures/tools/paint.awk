# figures/tools/paint.awk: a drawing as TeX with PDF operators, from rows with tabs between:
#   window x0 y0 x1 y1             what is shown, as wide as the option `width` says, in centimetres; the first row
#   disc   COLOUR x y r            a dot of a round pen: 30 bytes, and round at any resolution
#   ring   COLOUR x y r w          its rim; w is in points, as of a line
#   line   COLOUR x0 y0 x1 y1 w
#   curve  COLOUR w x y x y ...    an open line through points
#   arc    COLOUR x y r from to w  a part of a rim, between two angles, counterclockwise
#   dash   ON OFF                  what comes next is drawn in dashes of so many points, until `dash` alone
#   box    COLOUR x0 y0 x1 y1
#   path   COLOUR RIM w x y x y ...   a polygon, filled, with its rim
#   outline NAME x y x y ...       a polygon about the origin, which rows `shape` repeat: written once, however many there are
#   shape  NAME COLOUR RIM w x y r c s   it, filled, with its rim, r times as large, turned by the angle of cosine c and sine s
#   clip   x0 y0 x1 y1             nothing outside this is drawn, until `clip` alone; an error if all that comes between has its centre there
#   ball   NAME x y r              what a row `light` has described before
#   light  NAME RIM TOP            a ball of colour RIM with a darker edge, lit from the upper left, where it is TOP
#   words  x y WORDS               in the middle there; `words x y WORDS left` begins there
# A colour is rrggbb. Numbers are rounded to a hundredth of a point, so the bytes are the same on all machines.
function number(v, places,   s) {
  s = sprintf("%.*f", places, v); sub(/0+$/, "", s); sub(/\.$/, "", s)
  return s == "-0" ? "0" : s
}
function n(v) { return number(v, 2) }
function at(x, y) { return n((x - x0) * scale) " " n((y - y0) * scale) }
function part(c, i, f) { return number(f * (16 * (index(digits, substr(c, i, 1)) - 1) + index(digits, substr(c, i + 1, 1)) - 1) / 255, 3) }
function darker(c, f) { return part(c, 1, f) " " part(c, 3, f) " " part(c, 5, f) }
function rgb(c) { return darker(c, 1) }
function put(s) { printf "%s%s", (held++ ? "\n" : "\\pdfliteral{"), s; if (held == 50) rest() }
function rest() { if (held) print "}%"; held = 0 }
function pen(c, w) {
  if (c != ink) put(rgb(ink = c) " RG")
  if ((w = number(w, 4)) != nib) put((nib = w) " w")
}
function area(a, b, c, d) { return at(a, b) " " n((c - a) * scale) " " n((d - b) * scale) " re" }
# The control points of the quarters of a circle.
function circle(x, y, r,   k) {
  k = 0.5522847 * r
  return at(x + r, y) " m " at(x + r, y + k) " " at(x + k, y + r) " " at(x, y + r) " c " \
    at(x - k, y + r) " " at(x - r, y + k) " " at(x - r, y) " c " at(x - r, y - k) " " at(x - k, y - r) " " at(x, y - r) " c " \
    at(x + k, y - r) " " at(x + r, y - k) " " at(x + r, y) " c"
}
BEGIN { FS = "\t"; digits = "0123456789abcdef" }
$1 == "window" {
  x0 = $2; y0 = $3; scale = width * 72 / 2.54 / ($4 - $2); W = n(width * 72 / 2.54); H = n(($5 - $3) * scale)
  print "\\begingroup\\def\\balls{}\\unitlength1bp"
  next
}
$1 == "light" {
  print "\\immediate\\pdfobj{<</ShadingType 3/ColorSpace/DeviceRGB/Coords[0 0 .97 -.33 .36 .12]/Extend[false true]"
  print "/Function<</FunctionType 2/Domain[0 1]/N 2/C0[" rgb($3) "]/C1[" rgb($4) "]>>>>}\\edef\\light{\\the\\pdflastobj}%"
  print "\\immediate\\pdfobj stream attr{/Type/XObject/Subtype/Form/BBox[-1 -1 1 1]/Resources<</Shading<</L \\light\\space 0 R>>>>}"
  print "{" darker($3, 0.8) " RG 2 w 1 J 0 0 m 0 0 l S /L sh}\\edef\\balls{\\balls/" $2 " \\the\\pdflastobj\\space 0 R}%"
  next
}
$1 == "outline" {
  p = number($3, 4) " " number($4, 4) " m"
  for (i = 5; i < NF; i += 2) p = p "\n" number($i, 4) " " number($(i + 1), 4) " l"
  rest(); print "\\immediate\\pdfobj stream attr{/Type/XObject/Subtype/Form/BBox[-99 -99 99 99]}"
  print "{1 j " p " b}\\xdef\\balls{\\balls/" $2 " \\the\\pdflastobj\\space 0 R}%"
  next
}
$1 == "words" { said = said sprintf("\\put(%s,%s){\\makebox(0,0)%s{%s}}%%\n", n(($2 - x0) * scale), n(($3 - y0) * scale), ($5 == "left" ? "[l]" : ""), $4); next }
!begun { begun = 1; printf "\\setbox0\\hbox to%sbp{", W; put("q 1 J") }
$1 == "disc" { pen($2, 2 * $5 * scale); p = at($3, $4); put(p " m " p " l S"); things++ }
$1 == "ring" { pen($2, $6); put(circle($3, $4, $5) " S") }
$1 == "line" { pen($2, $7); put(at($3, $4) " m " at($5, $6) " l S") }
$1 == "curve" {
  pen($2, $3); p = at($4, $5) " m"
  for (i = 6; i < NF; i += 2) p = p " " at($i, $(i + 1)) " l"
  put("1 j " p " S")
}
$1 == "arc" {
  pen($2, $8); pieces = int(($7 - $6) / 1.6) + 1; step = ($7 - $6) / pieces; t = $6
  p = at($3 + $5 * cos(t), $4 + $5 * sin(t)) " m"; k = $5 * 4 / 3 * sin(step / 4) / cos(step / 4)
  for (i = 0; i < pieces; i++) {
    u = t + step; x = $3 + $5 * cos(u); y = $4 + $5 * sin(u)
    p = p " " at($3 + $5 * cos(t) - k * sin(t), $4 + $5 * sin(t) + k * cos(t)) " " at(x + k * sin(u), y - k * cos(u)) " " at(x, y) " c"; t = u
  }
  put(p " S")
}
$1 == "dash" { put((NF > 1 ? "[" $2 " " $3 "]" : "[]") " 0 d") }
$1 == "box" { if ($2 != filled) put(rgb(filled = $2) " rg"); put(area($3, $4, $5, $6) " f") }
$1 == "path" {
  pen($3, $4); p = at($5, $6) " m"
  for (i = 7; i < NF; i += 2) p = p " " at($i, $(i + 1)) " l"
  filled = ""; put(rgb($2) " rg 1 j " p " b"); things++
}
$1 == "shape" {
  r = $8 * scale; pen($4, $5 / r); c = n(r * $9); t = n(r * $10); m = n(-r * $10)
  if ($3 != filled) put(rgb(filled = $3) " rg")
  put("q " c " " t " " m " " c " " at($6, $7) " cm/" $2 " Do Q"); things++
}
$1 == "disc" || $1 == "ball" { held_in += $3 >= c0 && $3 <= c1 && $4 >= d0 && $4 <= d1; within++ }
$1 == "shape" { held_in += $6 >= c0 && $6 <= c1 && $7 >= d0 && $7 <= d1; within++ }
$1 == "clip" { if (NF == 1 && within && !held_in) hidden = 1; c0 = $2; d0 = $3; c1 = $4; d1 = $5; within = held_in = 0 }
$1 == "clip" { put(NF > 1 ? "q " area($2, $3, $4, $5) " W n" : "Q"); ink = nib = filled = "" }
$1 == "ball" { r = n($5 * scale); put("q " r " 0 0 " r " " at($3, $4) " cm/" $2 " Do Q"); things++ }
END {
  if (!things) { print "paint.awk: nothing is drawn" > "/dev/stderr"; exit 1 }
  if (hidden) { print "paint.awk: all that a clip holds lies outside it" > "/dev/stderr"; exit 1 }
  put("Q"); rest(); print "\\hss}\\ht0=" H "bp\\dp0=0bp"
  print "\\immediate\\pdfxform resources{/XObject<<\\balls>>}0"
  printf "\\leavevmode\\begin{picture}(%s,%s)\\put(0,0){\\pdfrefxform\\pdflastxform}%%\n%s\\end{picture}\\endgroup\n", W, H, said
}
