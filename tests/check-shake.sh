#!/bin/bash
# tests/check-shake.sh: shaking as a scene asks for it: before, after, on the way, sampled, and in families.
. tests/tell.sh
shopt -s nullglob
say() { printf '%s\n' "$2" > "$tmp/$1.scene"; }            # say NAME TEXT
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
say one 'dimension = 3; realizations = 4; seed = 3; species = ( { name = "A"; radius = 0.5; number = 300; } ); fraction = 0.55;
make = { method = "crm"; growth = 0.2; }; shake = { radius = 0.05; sweeps = 20; marks = [1, 5, 20]; };
measure = { rdf = { reach = 4.5; step = 0.05; peaks = [3.2, 4.3]; gaps = [2.5, 3.2]; }; contact = {}; order = {}; histogram = {}; };
save = true;'
say plain "$(sed 's/shake = {[^}]*};//' "$tmp/one.scene")"

# --- before and after
stages() {
  run one one && run plain plain && cmp -s "$tmp"/one/made.pack-0.xyz "$tmp"/plain/pack-0.xyz &&
    ! cmp -s "$tmp"/one/pack-0.xyz "$tmp"/plain/pack-0.xyz || return 1
  for q in contact contact_first_bin Q6 min_gap peak1_R peak1_g gap1_g range window_variance; do
    [ "$(value "made.$q" "$tmp/one")" = "$(value $q "$tmp/plain")" ] && [ -n "$(value "shaken.$q" "$tmp/one")" ] ||
      { echo "$q before is not what it is without shaking"; return 1; }
  done
}
tell 'before shaking is what it is without' stages
tables() { grep -v '^#' "$tmp/one/made.rdf.tsv" > "$tmp/a"; grep -v '^#' "$tmp/plain/rdf.tsv" > "$tmp/b"; cmp -s "$tmp/a" "$tmp/b" &&
  [ "$(grep -vc '^#' "$tmp/one/shaken.rdf.tsv")" = "$(wc -l < "$tmp/b")" ]; }
tell 'and so are the tables' tables
work() { [ "$(value sweeps "$tmp/one")" = 20 ] && [ "$(value shake_trials "$tmp/one")" = 6000 ] &&
  awk -v a="$(value acceptance "$tmp/one")" 'BEGIN { exit !(a > 0.2 && a < 0.9) }'; }
tell 'sweeps and trials are counted, the acceptance is a share' work
changes() { awk -F'\t' -v q="$1" '{ v[$1] = $2 } END { r = v["shaken." q] / v["made." q] - 1 - v["change." q]
    exit !(r * r < 1e-20 && v["min_gap"] <= v["made.min_gap"] && v["min_gap"] > -1e-12) }' "$tmp/one/summary.tsv"; }
tell 'the change is a ratio less one' changes contact_first_bin
tell 'and that of a peak is one of heights' changes peak1_g
told() { paste "$tmp/one/made.rdf.tsv" "$tmp/one/shaken.rdf.tsv" | awk -F'\t' '/^#/ || $1 == "R" { next } { d = $5 - $2 - $7; n++
    if (d * d > 1e-20 || $8 > sqrt($3 * $3 + $6 * $6) * 3 || $1 != $4) bad++; some += $7 != 0 } END { exit !(n > 40 && some > 30 && !bad) }'; }
tell 'the table after shaking tells what has changed' told
marks() { awk -F'\t' '/^#/ { next } !h++ { for (i = 1; i <= NF; i++) c[$i] = i; next }
    { m[n + 0] = $1; w[n + 0] = $c["wandered"]; n++ }
    END { exit !(m[0] == 0 && m[1] == 1 && m[2] == 5 && m[3] == 20 && w[0] == 0 && w[1] > 0 && w[3] > w[2] && w[2] > w[1]) }' \
    "$tmp/one/shaking.tsv" && [ "$(value contact_first_bin_0 "$tmp/one")" = "$(value made.contact_first_bin "$tmp/one")" ] &&
    [ "$(value contact_first_bin_20 "$tmp/one")" = "$(value shaken.contact_first_bin "$tmp/one")" ]; }
tell 'the marks begin before and end after' marks
last() { [ -n "$(value "change.$1" "$tmp/one")" ] && [ "$(grep -P "^change.${1}_20\t" "$tmp/one/summary.tsv" | cut -f2-)" = \
  "$(grep -P "^change.$1\t" "$tmp/one/summary.tsv" | cut -f2-)" ]; }
tell 'the change at the last mark is that of all shakes' last contact_first_bin
highest() { local stage; for stage in made shaken; do
    awk -F'\t' '/^#/ || $1 == "R" { next } !most || $2 > most { most = $2; R = $1; e = $3 } END { print R, most, e }' "$tmp/one/$stage.rdf.tsv" > "$tmp/a"
    awk -F'\t' -v q="$stage.highest" '$1 == q "_R" { R = $2 } $1 == q "_g" { print R, $2, $3 }' "$tmp/one/summary.tsv" > "$tmp/b"
    [ -s "$tmp/b" ] && cmp -s "$tmp/a" "$tmp/b" || return 1; done; changes highest_g; }
tell 'the highest bin is that of the table' highest
windows() { awk -F'\t' '/^#/ { next } FILENAME ~ /made/ { made[$1] = $2; next } FILENAME ~ /shaken.hist/ { shaken[$1] = $2; next }
    $1 ~ /^change.p_/ { n = substr($1, 10); d = shaken[n] / made[n] - 1 - $2; if (d * d > 1e-18) bad++; some += $2 != 0 } END { exit !(some > 4 && !bad) }' \
    "$tmp"/one/{made.histogram,shaken.histogram,summary}.tsv; }
tell 'windows with so many centres have their changes' windows
none() { sed 's/sweeps = 20; marks = [^;]*;/sweeps = 0;/' "$tmp/one.scene" > "$tmp/none.scene"
  run none none && cmp -s "$tmp"/none/{made.,}pack-0.xyz && [ "$(value change.contact "$tmp/none")" = 0 ]; }
tell 'no sweep changes nothing' none

# --- how certain the place of a trough is: its errors against its scatter over 12 seeds, whose ratio is known to a fifth
say flat 'dimension = 2; realizations = 16; species = ( { radius = 1.0; number = 300; } ); fraction = 0.25; make = { method = "rsa"; };
measure = { rdf = { reach = 6.0; step = 0.05; gaps = [2.5, 5.5]; }; };'
scatter() {
  for s in {1..12}; do run flat flat --set seed=$s || return 1; grep "^$1" "$tmp/flat/summary.tsv"; done > "$tmp/a"
  awk '{ s += $2; t += $2 * $2; e += $3 * $3 } END { r = sqrt((t - s * s / NR) / (NR - 1) / (e / NR)); exit !(NR == 12 && r > 0.6 && r < 1.7) }' "$tmp/a"
}
tell 'the place of a trough is as uncertain as it scatters' scatter gap1_R
tell 'and its height' scatter gap1_g

# --- rules and samples
for rule in retry collision collision-longest chain newton dynamics; do
  other() { run one "$rule" --set shake.rule=$rule --set shake.tries=4 && ! cmp -s "$tmp/$rule/pack-0.xyz" "$tmp/one/pack-0.xyz" &&
    cmp -s "$tmp/$rule/made.pack-0.xyz" "$tmp/one/made.pack-0.xyz" &&
    awk -v g="$(value min_gap "$tmp/$rule")" 'BEGIN { exit !(g > -1e-12) }'; }
  tell "$rule is another way from the same pack, without overlap" other
done
sampled() { run one sampled --set shake.rule=$1 --set shake.samples=5 --set shake.apart=3 &&
  [ "$(value shaken.contact "$tmp/sampled")" != "$(value shaken.contact "$tmp/$1")" ] &&
    awk -v g="$(value shaken.peak1_g "$tmp/sampled")" -v h="$(value shaken.peak1_g "$tmp/$1")" \
      'BEGIN { exit !(g > 0.8 * h && g < 1.25 * h) }' || return 1
  [ "$2" = no ] || awk -v z="$(value shaken.contact_collision "$tmp/sampled")" -v g="$(value shaken.contact "$tmp/sampled")" \
    'BEGIN { exit !(z > 0.8 * g && z < 1.25 * g) }'; }
tell 'samples are averaged' sampled retry no
tell 'chains tell the pressure' sampled chain yes
tell 'dynamics tells the pressure' sampled dynamics yes

# --- on the way
way() { sed 's/sweeps = 20; marks = [^;]*;/sweeps = 0; every = 2.0; each = 3;/' \
    "$tmp/one.scene" > "$tmp/way.scene"
  run way way && ! cmp -s "$tmp"/way/pack-0.xyz "$tmp"/plain/pack-0.xyz &&
    awk -v s="$(value sweeps "$tmp/way")" 'BEGIN { exit !(s > 20) }' &&
    awk -v g="$(value min_gap "$tmp/way")" -v f="$(value fraction "$tmp/way")" 'BEGIN { exit !(g > -1e-12 && (f - 0.55) ^ 2 < 1e-26) }'; }
tell 'shakes on the way, and the fraction is met' way

# --- families
say family "$(sed 's/save = true;/sweep = ( { key = "shake.rule"; values = ("metropolis", "retry"); }, { key = "fraction"; values = [0.5, 0.55]; } );/
  s/marks = [^;]*;//' "$tmp/one.scene")"
family() {
  run family family && run one alone --set fraction=0.5 --set shake.rule=retry --set 'measure.histogram={}' || return 1
  for q in made.contact shaken.contact collisions change.peak1_g; do
    [ "$(value "$q@retry@0.5" "$tmp/family")" = "$(value $q "$tmp/alone")" ] || { echo "$q differs in a family"; return 1; }
  done
}
tell 'a pack that serves a family is the pack of its scene' family
# apart KEY VALUE VALUE: each of the two makes its own packs.
apart() {
  sed "s/sweep = .*/sweep = ( { key = \"$1\"; values = [$2, $3]; } );/; s/sweeps = 20/sweeps = 2; every = ${4:-0.0}/" \
    "$tmp/family.scene" > "$tmp/apart.scene"
  run apart apart && run apart single --set 'sweep=()' --set "$1=$3" || return 1
  [ "$(value "collisions@$3" "$tmp/apart")" = "$(value collisions "$tmp/single")" ] &&
    [ "$(value "collisions@$2" "$tmp/apart")" != "$(value "collisions@$3" "$tmp/apart")" ]
}
tell 'who grow otherwise are no family' apart make.growth 0.2 0.4
tell 'nor are those who are shaken otherwise on the way' apart shake.radius 0.05 0.2 2.0
# What a combination takes over from the one before it, measured or shaken, is what it has by itself.
taken_over() { # taken_over KEY VALUES KEY VALUES SETTING...: the second key changes faster
  local a b
  sed "s/^save = .*/sweep = ( { key = \"$1\"; values = [${2/ /, }]; }, { key = \"$3\"; values = [${4/ /, }]; } );/; s/marks = [^;]*;//" \
    "$tmp/one.scene" > "$tmp/over.scene"
  local set=(--set realizations=1 "${@:5}")
  run over over "${set[@]}" || return 1
  for a in $2; do for b in $4; do
    run over alone --set 'sweep=()' --set "$1=$a" --set "$3=$b" "${set[@]}" || return 1
    awk -F'\t' -v at="@$a@$b" '/^(#|quantity)/ { next } FNR == NR { alone[$1] = $2; n++; next }
      sub(at "$", "", $1) && $1 in alone { both++; other += alone[$1] != $2 } END { exit !(n > 40 && both == n && !other) }' \
      "$tmp/alone/summary.tsv" <(grep "@$a@$b" "$tmp/over/summary.tsv") || { echo "@$a@$b is not what it is alone"; return 1; }
  done; done
}
tell 'a shaken pack is measured in two ways' taken_over shake.radius '0.05 0.2' measure.histogram.radius '2.2 2.5'
tell 'a pack is measured once for two ways to shake it' taken_over measure.histogram.radius '2.2 2.5' shake.radius '0.05 0.2'
tell 'samples are measured as they are taken' taken_over shake.radius '0.05 0.2' measure.histogram.radius '2.2 2.5' --set shake.samples=3
planned() { ends 0 "$randpack" plan "$tmp/one.scene" && grep -q '^shake.metropolis R_sh=0.05, 20 after' "$tmp/out" || return 1
  for file in $(sed -n 's/^write.//p' "$tmp/out" | tr ' ' '\n' | grep tsv); do [ -e "$tmp/one/$file" ] || { echo "no $file"; return 1; }; done; }
tell 'the plan tells the rule and the tables' planned
exit $failed
