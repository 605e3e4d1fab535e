#!/bin/bash
# tests/check-mixture.sh: pairs of species as a scene asks for them: tables, numbers, extrema, and theory beside them.
. tests/tell.sh
shopt -s nullglob
say() { printf '%s\n' "$2" > "$tmp/$1.scene"; }            # say NAME TEXT
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
same() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && (a - b) ^ 2 <= 1e-20 * (1 + a * a)) }' || { echo "$1 and $2"; return 1; }; }
columns() { grep -v '^#' "$tmp/$1" | cut -f"$2"; }         # columns TABLE LIST
say one 'dimension = 3; realizations = 3; seed = 7; species = ( { name = "A"; radius = 0.5; number = 300; } ); fraction = 0.5;
make = { method = "crm"; growth = 0.2; };
measure = { rdf = { reach = 4.5; step = 0.05; peaks = [3.2, 4.3]; }; contact = { step = 0.05; }; nearest = {}; coordination = {};
  partials = { scale = "r"; reach = [4.5]; step = 0.05; extrema = ( { pair = "A-A"; peak = [3.2, 4.3]; } ); }; };'
say two 'dimension = 3; realizations = 3; seed = 7; species = ( { name = "L"; radius = 0.5; number = 40; }, { name = "S"; radius = 0.2; number = 400; } );
fraction = 0.5; make = { method = "crm"; growth = 0.2; }; shake = { radius = 0.1; sweeps = 10; };
measure = { K = { reach = 3.0; step = 0.2; }; partials = { scale = "r"; reach = [3.0]; step = 0.2;
  extrema = ( { pair = "L-S"; peak = [1.5, 2.3]; }, { pair = "L-S"; gap = [1.4, 2.4]; }, { pair = "S-S"; gap = [0.9, 1.7]; } ); }; };
theory = { mixture = true; };'

# --- one species
run one one; run two two
tell 'one species: g by pairs of species is g' cmp -s <(columns one/rdf.tsv 1-3 | tail -n +2) <(columns one/partial.A-A.tsv 1,3,4 | tail -n +2)
single() {
  for q in contact contact_first_bin peak1_R peak1_g coordination; do same "$(value $q "$tmp/one")" "$(value $q.A-A "$tmp/one")" || return 1; done
  awk -v a="$(value nearest "$tmp/one")" -v b="$(value nearest.A-A "$tmp/one")" 'BEGIN { exit !((a - 2 - b) ^ 2 < 1e-20) }'
}
tell 'and so are its numbers' single

# --- two species
sum_rule() {
  awk -F'\t' '/^#/ || /^R/ { next } FNR < last { files++ } { last = FNR } FILENAME ~ /K.tsv/ { all[sprintf("%.6f", $1)] = $2; next }
      { pairs = FILENAME ~ /L-L/ ? 780 : FILENAME ~ /L-S/ ? 16000 : 79800; e = sprintf("%.6f", $5); sum[e] += pairs * $6; n[e]++ }
      END { for (e in sum) if (n[e] == 3) { seen++; r = sum[e] / (440 * 439 / 2 * all[e]) - 1; if (r * r > 1e-20) bad++ }
        exit !(seen == 5 && !bad) }' "$tmp/two/$1.K.tsv" "$tmp/two/$1".partial.*.tsv
}
tell 'the pairs of all species are all pairs, before' sum_rule made
tell 'and after' sum_rule shaken
numbers() {
  same "$(value made.number.L "$tmp/two")" 40 && same "$(value made.number.S "$tmp/two")" 400 &&
    awk -v l="$(value made.volume.L "$tmp/two")" -v s="$(value made.volume.S "$tmp/two")" \
      'BEGIN { exit !((l + s - 1) ^ 2 < 1e-20 && (l / s - 40 * 0.125 / (400 * 0.008)) ^ 2 < 1e-20) }'
}
tell 'numbers and volumes of species' numbers
change() { awk -F'\t' '{ v[$1] = $2 } END { n = split("contact.L-L contact.L-S contact_first_bin.S-S nearest.S-L peak1_g.L-S gap1_g.S-S", q, " ")
    for (i = 1; i <= n; i++) { r = v["shaken." q[i]] / v["made." q[i]] - 1 - v["change." q[i]]; if (!(q[i] in seen) && (v["made." q[i]] == 0 || r * r > 1e-18)) bad = 1 }
    exit bad }' "$tmp/two/summary.tsv"; }
tell 'a change is a ratio less one' change
first_bin() { for p in L-L L-S S-S; do same "$(columns two/made.partial.$p.tsv 3 | sed -n 2p)" "$(value made.contact_first_bin.$p "$tmp/two")" || return 1; done; }
tell 'the first bin is that of the table' first_bin
middle() { columns two/made.partial.L-S.tsv 1-2,5 | awk -F'\t' 'NR == 1 { next } { bad += ($1 - 1.4 - (NR - 1.5) * 0.2) ^ 2 > 1e-18 || ($2 - 2 * $1 / 1.4) ^ 2 > 1e-18 || ($3 - $1 - 0.1) ^ 2 > 1e-18 } END { exit !(NR == 9 && !bad) }'; }
tell 'bins begin at contact' middle
neighbours() { awk -F'\t' '/^#/ || /^R/ { next } { k = $6; n = $8 } END { exit !((n - 400 * k / (4 / 3 * 3.14159265358979 * (40 + 400 * 0.064) / 0.5)) ^ 2 < 1e-18) }' "$tmp/two/made.partial.L-S.tsv"; }
tell 'the neighbours of a large sphere follow from K' neighbours

samples() { run two samples --set shake.samples=3 && [ "$(value shaken.number.L "$tmp/samples")" = 40 ] &&
  awk -v a="$(columns samples/shaken.partial.S-S.tsv 6 | tail -1)" -v b="$(columns two/shaken.partial.S-S.tsv 6 | tail -1)" 'BEGIN { exit !(a != b && (a / b - 1) ^ 2 < 1e-3) }'; }
tell 'samples of pairs are averaged' samples

# --- scales: the same pairs, each scale with its own step
scales() {
  run two common --set measure.partials.scale='"common"' --set measure.partials.step=0.1 --set 'measure.partials.extrema=({pair="L-S";gap=[2.2,3.4];})' --set 'measure.partials.reach=[4.0,4.2,4.0]' &&
    run two source --set measure.partials.scale='"source"' --set measure.partials.step=0.175 --set 'measure.partials.extrema=({pair="L-S";gap=[2.35,4.45];})' --set 'measure.partials.reach=[4.0,5.85,4.0]' || return 1
  cmp -s <(columns common/made.partial.L-S.tsv 3) <(columns source/made.partial.L-S.tsv 3) || { echo 'other bins'; return 1; }
  # (r - a_L)/a_S + 1 from 2 r/(a_L + a_S)
  awk -v c="$(value made.gap1_R.L-S "$tmp/common")" -v s="$(value made.gap1_R.L-S "$tmp/source")" \
    'BEGIN { s -= (0.7 * c - 1) / 0.4 + 1; exit !(c > 2.2 && c < 3.4 && s * s < 1e-16) }' || { echo 'another place'; return 1; }
}
tell 'a gap is at one place on every scale' scales
places() { awk -v p="$(value made.peak1_R.L-S "$tmp/two")" -v g="$(value made.gap1_R.L-S "$tmp/two")" -v s="$(value made.gap1_R.S-S "$tmp/two")" \
    -v high="$(value made.peak1_g.L-S "$tmp/two")" -v low="$(value made.gap1_g.L-S "$tmp/two")" 'BEGIN { exit !(p > 1.4 && p < 2.4 && g > 1.3 && g < 2.5 && s > 0.8 && s < 1.8 && high > low && low > 0) }'; }
tell 'peaks and gaps are counted for each pair, in their intervals' places

# --- theory
theory() {
  run two near --set 'measure.partials={scale="r";step=0.001;reach=[2.01,1.41,0.81];}' || return 1
  for p in L-L L-S S-S; do
    awk -v g="$(columns near/made.partial.$p.tsv 10 | sed -n 2p)" -v c="$(value contact_py.$p "$tmp/near")" -v b="$(value contact_bmcsl.$p "$tmp/near")" \
      'BEGIN { exit !(g > 0.985 * c && g < c && b > c) }' || { echo "py of $p"; return 1; }
  done
  awk -v z="$(value Z_py "$tmp/near")" -v b="$(value Z_bmcsl "$tmp/near")" -v l="$(value py_limit "$tmp/near")" 'BEGIN { exit !(z > 4 && b > z && l > 0.5 && l < 0.7) }'
}
tell 'the curve of theory ends at its contact value' theory
means() { # of bins of .2 and of .1
  run two half --set measure.partials.step=0.1 || return 1
  paste <(columns two/made.partial.L-S.tsv 5,10 | tail -n +2) <(columns half/made.partial.L-S.tsv 5,10 | tail -n +2 | paste - -) |
    awk -F'\t' '{ a = $1 - 0.2; m = $1 - 0.1; x = ($4 * (m ^ 3 - a ^ 3) + $6 * ($1 ^ 3 - m ^ 3)) / ($1 ^ 3 - a ^ 3); if ((x - $2) ^ 2 > 1e-11) bad = 1 } END { exit !(NR == 8 && !bad) }'
}
tell 'a bin of theory is the mean of its halves' means
alike() { sed 's/radius = 0.5; n/radius = 1.0; n/; s/radius = 0.2; n/radius = 0.4; n/' "$tmp/two.scene" > "$tmp/large.scene"; run large large && cmp -s <(columns two/made.partial.L-S.tsv 10) <(columns large/made.partial.L-S.tsv 10); }
tell 'theory is of ratios, not of units' alike
without() { sed 's/^make = .*shake/shake/; s/shake = {[^}]*};//; s/^measure.*//; s/^  extrema.*//' "$tmp/two.scene" > "$tmp/none.scene"; sed -i 's/^fraction = 0.5; .*/fraction = 0.5;/' "$tmp/none.scene"
  run none none && same "$(value contact_py.L-S "$tmp/none")" "$(value contact_py.L-S "$tmp/two")"; }
tell 'theory needs no packs' without

lebowitz() { # Percus and Yevick's contact values: 1/(1 - phi) + 3 zeta_2 a_k a_m / (a_k + a_m) / (1 - phi)^2, lengths in a_L
  awk -F'\t' '$1 ~ /^contact_py/ { v[$1] = $2 } END { n = 0.5 / (4 / 3 * 3.14159265358979 * (40 + 400 * 0.064)); z = 4 / 6 * 3.14159265358979 * n * (40 + 400 * 0.16)
      split("L-L L-S S-S", p, " "); split("1 1 0.4", a, " "); split("1 0.4 0.4", b, " ")
      for (i = 1; i <= 3; i++) { g = 2 + 3 * z * 2 * a[i] * b[i] / (a[i] + b[i]) / 0.25; if ((v["contact_py." p[i]] - g) ^ 2 > 1e-11) bad = 1 }
      exit bad }' "$tmp/two/summary.tsv"; }
tell 'contact values are those of the mixture of the scene' lebowitz
absent() {
  sed 's/number = 40;/number = 0;/; s/radius = 0.2; number = 400/radius = 0.15; number = 1000/; s/reach = 3.0; step = 0.2; };/reach = 1.0; step = 0.2; };/; s/reach = \[3.0\]/reach = [2.4, 2.4, 1.7]/' "$tmp/two.scene" > "$tmp/absent.scene"
  run absent absent && [ "$(value made.number.L "$tmp/absent")$(value made.contact.L-S "$tmp/absent")" = 00 ] && same "$(value contact_py.S-S "$tmp/absent")" 5 &&
    ! grep -q nan "$tmp/absent/summary.tsv"; }
tell 'an absent species' absent
alone() {
  sed 's/number = 40;/number = 1;/; s/^theory.*//; s/growth = 0.2/growth = 2.0/; s/S"; radius = 0.2; number = 400/S"; radius = 0.05; number = 4000/; s/realizations = 3/realizations = 2/; s/K = {[^}]*};//; s/reach = \[3.0\]/reach = [3.0, 1.6, 0.8]/; s/\[1.5, 2.3\]/[1.11, 1.6]/; s/\[1.4, 2.4\]/[1.11, 1.19]/
    s/\[0.9, 1.7\]/[0.3, 0.7]/; s/step = 0.2/step = 0.05/' "$tmp/two.scene" > "$tmp/alone.scene"
  run alone alone && [ "$(value made.number.L "$tmp/alone")" = 1 ] && [ "$(columns alone/made.partial.L-L.tsv 1 | wc -l)" = 1 ] &&
    [ "$(columns alone/made.partial.L-S.tsv 1 | wc -l)" -gt 1 ]; }
tell 'a large particle alone has no bins' alone

# --- files
planned() { ends 0 "$randpack" plan "$tmp/two.scene" || return 1
  for file in $(sed -n 's/^write.//p' "$tmp/out" | tr ' ' '\n' | grep tsv); do [ -e "$tmp/two/$file" ] || { echo "no $file"; return 1; }; done
  [ "$(find "$tmp/two" -name '*partial*' | wc -l)" = 6 ] && [ "$(grep -c 'nan' "$tmp/two/summary.tsv")" = 0 ]; }
tell 'the plan tells the tables' planned
again() { run one saved --set save=true && ends 0 "$randpack" measure "$tmp"/saved/pack-0.xyz "$tmp"/saved/pack-1.xyz "$tmp"/saved/pack-2.xyz --scene "$tmp/one.scene" --out "$tmp/again" &&
  cmp -s <(columns one/partial.A-A.tsv 1-9) <(columns again/partial.A-A.tsv 1-9); }
tell 'saved packs measure the same' again
sweep() { sed 's/^make/sweep = ( { key = "fraction"; values = [0.4, 0.5]; } ); make/; s/fraction = 0.5; make/fraction = 0.5; sweep = ( { key = "fraction"; values = [0.4, 0.5]; } ); make/' "$tmp/two.scene" > "$tmp/sweep.scene"
  run sweep sweep && cmp -s <(columns sweep/made.partial.L-S@0.5.tsv 1-10) <(columns two/made.partial.L-S.tsv 1-10) &&
    same "$(value change.contact.L-S@0.5 "$tmp/sweep")" "$(value change.contact.L-S "$tmp/two")"; }
tell 'in a sweep as alone' sweep
exit $failed
