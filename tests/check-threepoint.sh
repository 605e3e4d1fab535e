#!/bin/bash
# tests/check-threepoint.sh: three points in a scene, by both methods, of both phases, and of a pack from a file.
. tests/tell.sh
run() { ends 0 "$randpack" run "$tmp/a.scene" --out "$tmp/$1" "${@:2}"; } # run DIR SETTING...
cat > "$tmp/a.scene" <<'END'
dimension = 2; seed = 5; realizations = 3; fraction = 0.3; save = true;
species = ( { name = "P"; radius = 2.0; number = 60; shape = { kind = "polygon"; sides = 4; }; } );
make = { method = "sequential"; };
measure = { S3 = { step = 0.5; reach = 2.0; theta = [0.0, 90.0]; samples = 20000.0; }; };
END
# awk over the rows of a table: S[theta, R1, R2], and its error e.
table() { awk -F'\t' "!/^#/ && NR > 1 { if (\$1 != \"theta\") { S[\$1, \$2, \$3] = \$4; e[\$1, \$2, \$3] = \$5; n++ } } END { exit !($2) }" "$tmp/$1/S3.tsv"; }
columns() { run one && [ "$(grep -v '^#' "$tmp/one/S3.tsv" | head -1)" = $'theta\tR1\tR2\tS3\tS3_err' ] && table one 'n == 50'; }
tell 'S3 has its columns, and a row a cell' columns
tell 'its edges and its diagonal are one function, to the last digit' table one \
  'S[0, 1.5, 1.5] == S[0, 0, 1.5] && S[0, 1.5, 0] == S[0, 0, 1.5] && S[90, 1.5, 0] == S[0, 0, 1.5] && S[0, 1.5, 1.5] < S[0, 1, 1]'
tell 'it begins with the fraction' table one '(S[0, 0, 0] - 0.3) ^ 2 < 25 * e[0, 0, 0] ^ 2 && e[0, 0, 0] < 0.005 && e[0, 0, 0] > 0'
larger() { run large --set species.[0].radius=4.0 && awk '!/^#/' "$tmp/large/S3.tsv" > "$tmp/b" && awk '!/^#/' "$tmp/one/S3.tsv" | diff - "$tmp/b"; }
tell 'arms are in radii of the first species' larger
matrix() { run matrix --set 'measure.S3.phase="matrix"' && table matrix '(S[90, 0, 0] - 0.7) ^ 2 < 25 * e[90, 0, 0] ^ 2 && S[90, 2, 2] > 0.25'; }
tell 'the matrix is the other phase' matrix
one() { run single --set realizations=1 && table single 'e[90, 0, 1] > 0 && e[90, 0, 1] < 0.01' && ! grep -q S3_correlation "$tmp/single/summary.tsv"; }
tell 'one pack has the error of its sampling' one
triangles() { run three --set 'measure.S3.method="triangles"' &&
  paste <(grep '^[0-9]' "$tmp/one/S3.tsv") <(grep '^[0-9]' "$tmp/three/S3.tsv") |
  awk -F'\t' '{ d = $4 - $9; if (d * d > 0.015 ^ 2) bad = 1 } END { exit bad || NR != 50 }' &&
  awk -v r="$(value S3_neighbours "$tmp/three")" -v s="$(value S3_neighbours "$tmp/one")" 'BEGIN { exit !(r < 0.2 && s > 0.5) }'; }
tell 'triangles of their own for each cell find the same, and cells are not alike' triangles
error() { run error --set measure.S3.error=0.001 && awk -v e="$(value S3_error "$tmp/error")" -v n="$(value S3_samples "$tmp/error")" 'BEGIN { exit !(e <= 0.001 && n > 20000) }'; }
tell 'an error that is asked for' error
# The error over packs, from packs of which one is left out: the samples are others then, so there are many of them.
lacking() { # lacking PACKS LEFT_OUT: the correlation without it
  local k files=()
  for ((k = 0; k < $1; k++)); do [ "$k" = "$2" ] || files+=("$tmp/many/pack-$k.xyz"); done
  ends 0 "$randpack" measure "${files[@]}" --scene "$tmp/a.scene" --set measure.S3.samples=1000000.0 --out "$tmp/less" && value S3_correlation "$tmp/less"
}
jackknife() {
  local k n=6
  run many --set realizations=$n --set measure.S3.samples=1000000.0 || return
  for ((k = 0; k < n; k++)); do lacking $n $k || return; done |
    awk -v told="$(awk -F'\t' '$1 == "S3_correlation" { print $3 }' "$tmp/many/summary.tsv")" '{ r[NR] = $1; mean += $1 }
      END { mean /= NR; for (k = 1; k <= NR; k++) s += (r[k] - mean) ^ 2; e = sqrt((NR - 1) / NR * s)
        if (NR != 6 || !(told > 0.9 * e && told < 1.1 * e)) { print "told", told, "by leaving out", e; exit 1 } }'
}
tell 'the correlation over packs has the error of leaving out each' jackknife
file() { ends 0 "$randpack" measure "$tmp"/one/pack-{0,1,2}.xyz --scene "$tmp/a.scene" --out "$tmp/file" &&
  diff <(grep -v '^#' "$tmp/one/S3.tsv") <(grep -v '^#' "$tmp/file/S3.tsv") > "$tmp/diff"; }
tell 'measured from files it is the same' file
threads() { run two --threads 2 && cmp -s "$tmp/one/S3.tsv" "$tmp/two/S3.tsv" && RANDPACK_SIMD=default run narrow && cmp -s "$tmp/one/S3.tsv" "$tmp/narrow/S3.tsv"; }
tell 'the bytes are those of any threads and width' threads
exit $failed
