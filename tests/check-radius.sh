#!/bin/bash
# tests/check-radius.sh: figures/tomography/radius-read.awk on an exponential peak, 1 + 19 exp(-y / 0.05), whose smeared form is computed here by plain sums.
. tests/tell.sh
# table FILE STEP [SPREAD]: g of equal spheres, or smeared, R in median radii; made.rdf and shaken.rdf are the same.
table() { awk -v d="$2" -v s="${3:-0}" 'BEGIN { OFS = "\t"; scale = exp(1.5 * s * s); print "R", "g", "g_err"
    for (R = (s ? 1.7 : 2) + d / 2; R < (s ? 2.7 : 5); R += d) { r = R / scale
      if (s == 0) f = 1 + 19 * 0.05 / d * (exp(-(R - d / 2 - 2) / 0.05) - exp(-(R + d / 2 - 2) / 0.05))
      else { f = u = 0; for (v = -4; v <= 4; v += 0.002) { y = r - 2 * exp(-s * s) - sqrt(2) * s * v; p = exp(-v * v / 2); u += p; f += y > 0 ? p * (1 + 19 * exp(-y / 0.05)) : 0 } }
      printf "%.9g\t%.9g\t0.001\n", R, s ? f / u : f } }' > "$tmp/$1"; }
table rdf@0.tsv 0.005; table rdf@0.05.tsv 0.005 0.05; table made.rdf.tsv 0.01; cp "$tmp/made.rdf.tsv" "$tmp/shaken.rdf.tsv"
awk -v dir="$tmp" -f figures/tomography/radius-read.awk "$tmp"/{made,shaken}.rdf.tsv "$tmp"/rdf@*.tsv > "$tmp/read.tsv"
near() { awk -F'\t' -v r="$1" -v v="$2" -v t="$3" '$1 == r { d = $2 - v; good = d * d <= t * t } END { exit !good }' "$tmp/read.tsv"; } # ROW VALUE TOLERANCE
top() { awk -F'\t' 'NR > 1 && $2 > m { m = $2; R = $1 / exp(0.00375) } END { print '"$1"' }' "$tmp/rdf@0.05.tsv"; }
tell 'the value at contact' near h 20 0.1
tell 'the area' near area 0.95 1e-3
tell 'its depth' near depth 0.05 5e-4
tell 'the peak of the smeared table, as in its own' near smeared@0.05 "$(top m)" 0.05
tell 'and by the formula' near model@0.05 "$(top m)" 0.05
tell 'and by a parabola' near top@0.05 "$(top m)" 0.05
tell 'the place of the peak' near top_R@0.05 "$(top R)" 0.004
tell 'that of the smeared table' near smeared_R@0.05 "$(top R)" 0.004
tell 'the limit' near limit@0.05 "$(awk 'BEGIN { print 0.5 + 0.95 / (2 * sqrt(3.14159265) * 0.05) }')" 0.01
tell 'a radius too large: the bin at 2 is that at 2.1' near first_change@0@0.1@0.05 \
  "$(awk 'function bin(p, q) { s = 0; for (r = p + 5e-6; r < q; r += 1e-5) s += 3 * r * r * 1e-5 * (1 + 19 * exp(-(r - 2) / 0.05)); return s / (q ^ 3 - p ^ 3) }
    BEGIN { print bin(2.1, 2.205) / bin(2, 2.1) - 1 }')" 2e-3
tell 'one too small: it is empty' near first_change@0@0.1@-0.05 -1 0
tell 'nothing is between equal curves' near shaken@0.05 0 0
exit $failed
