#!/bin/bash
# tests/check-gravity.sh: packs by gravity from scenes: one size, several, by laws, diluted; finite packs in files and in statistics.
. tests/tell.sh
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
holds() { awk -F'\t' "{ v[\$1] = \$2; e[\$1] = \$3 } function near(a, b, t) { return (a - b) ^ 2 <= t * t } END { exit !($2) }" "$tmp/$1/summary.tsv" ||
  { echo "not so: $2"; return 1; }; } # holds DIR TEST
cat > "$tmp/one.scene" <<'END'
dimension = 3; seed = 6; realizations = 2; save = true;
species = ( { name = "A"; radius = 2.0; number = 3000; } );
make = { method = "gravity"; };
measure = { rdf = { step = 0.05; reach = 4.0; }; K = { step = 0.5; reach = 4.0; }; nearest = { reach = 3.0; step = 0.1; }; histogram = {};
            coordination = { tolerance = 1e-7; }; order = {}; profile = { step = 0.1; }; radial = { bins = 5; }; };
END
made() { run one one && holds one 'v["fraction"] > 0.58 && v["fraction"] < 0.62 && v["overlap"] < 1e-9 && v["min_gap"] > -1e-9 &&
  v["number"] == 3000 && v["coordination"] > 3 && v["coordination"] < 3.5 && v["rattlers"] == 1 && v["carry"] <= 0.3001 && v["passes"] > 0 && !("isostatic_excess" in v)'; }
tell 'spheres come to rest by gravity' made
profile() { awk -F'\t' '/^#/ || /^x/ { next } { n++; x = $1; phi = $2 } END { exit !(n == 10 && x == 1 && phi > 0.3 && phi < 0.5) }' "$tmp/one/profile.tsv" &&
  awk -F'\t' -v want="$(awk -F'\t' '$1 == 1 { print $2 }' "$tmp/one/profile.tsv")" '/^#/ || /^x/ { next }
    { sum += $2 * (($1 + 0.05) ^ 3 - ($1 - 0.05) ^ 3) } END { exit !((sum - want) ^ 2 < 1e-18) }' "$tmp/one/profile-shells.tsv"; }
tell 'its profile falls outwards, and shells add up to the ball' profile
solid() { awk -F'\t' '$1 == 1 { print $2 }' "$tmp/one/profile.tsv" > "$tmp/phi"
  holds one "near($(cat "$tmp/phi") * v[\"rim\"] ^ 3, 3000, 30)"; }
tell 'the whole holds all of them' solid
curves() { awk -F'\t' '/^#/ || /^R/ { next } { g[++n] = $2; k += 4 / 3 * 3.14159265 * $2 * (($1 + 0.025) ^ 3 - ($1 - 0.025) ^ 3) }
    END { exit !(n == 40 && g[1] > 10 && k > 255 && k < 282) }' "$tmp/one/rdf.tsv" &&
  awk -F'\t' '/^#/ || /^R/ { next } { k[$1] = $2 } END { exit !(k[1.5] == 0 && k[2.5] > 60 && k[2.5] < 85 && k[4] > 255 && k[4] < 282) }' "$tmp/one/K.tsv"; }
tell 'its pairs are counted from the core' curves
windows() { awk -F'\t' -v m="$(value window_mean "$tmp/one")" '/^#/ || /^n/ { next } { s += $2; t += $1 * $2 } END { exit !((s - 1) ^ 2 < 1e-12 && (t - m) ^ 2 < 1e-10) }' "$tmp/one/histogram.tsv" &&
  K=$(awk -F'\t' '$1 == 2.5 { print $2 }' "$tmp/one/K.tsv") && holds one "near(v[\"window_mean\"], $K * v[\"fraction\"] / (4 / 3 * 3.14159265), 0.6)"; }
tell 'windows on centres hold as many as K says' windows
deep() { # two spheres of radius 2 and a tolerance of 1e-7, in the part .6 of the radius
  awk 'FNR == 2 { match($0, /open=[^ ]*/); R = 0.6 * substr($0, RSTART + 5, RLENGTH - 5) - 4 * (1 + 1e-7); split($0, p, "[\" ]"); h = p[2] / 2 }
    FNR > 2 { n += ($2 - h) ^ 2 + ($3 - h) ^ 2 + ($4 - h) ^ 2 <= R * R } END { print n / 2 }' "$tmp"/one/pack-{0,1}.xyz > "$tmp/deep"
  holds one "v[\"coordination_centres\"] == $(cat "$tmp/deep") && v[\"coordination_centres\"] > 50"; }
tell 'the number of centres whose contacts count is told' deep
random() { run one random --set measure.histogram.centre=random && holds random 'near(v["window_mean"], v["fraction"] * 2.5 ^ 3, 0.15)'; }
tell 'and on random points as many as the fraction says' random
file() { head -2 "$tmp/one/pack-0.xyz" | grep -q 'pbc="F F F".* open=' &&
  ends 0 "$randpack" measure "$tmp"/one/pack-{0,1}.xyz --scene "$tmp/one.scene" --out "$tmp/again" || return 1
  for f in rdf K nearest histogram profile profile-shells radial; do
    cmp -s <(grep -v '^#' "$tmp/one/$f.tsv") <(grep -v '^#' "$tmp/again/$f.tsv") || { echo "$f differs"; return 1; }; done
  for q in fraction reach coordination Q6 radial_order centres min_gap; do
    [ "$(value $q "$tmp/one")" = "$(value $q "$tmp/again")" ] || { echo "$q differs"; return 1; }; done; }
tell 'the file of a finite pack says so, and is measured the same' file
bounds() { run one bounds --set save=false --set 'measure={bounds={reach=6.0;error=1e-3;};}' &&
  holds bounds 'v["zeta2"] > 0.1 && v["zeta2"] < 0.3 && e["zeta2"] > 0 && v["eta2"] > 0.3 && v["eta2"] < 0.7 && v["bounds_error"] < 0.2' &&
  ends 1 "$randpack" run "$tmp/one.scene" --out "$tmp/none" --set 'measure={bounds={reach=20.0;};}' && grep -q 'measure.bounds needs a centre in the core, R = 20 or more from its edge, and there is none, the deepest is at R = .*; give' "$tmp/err"; }
tell 'its bounds are of hosts that have all of the reach in the core' bounds
threads() { run one t1 --threads 1 && run one t2 --threads 2 && diff -r "$tmp/t1" "$tmp/t2"; }
tell 'with one thread and with two the same' threads
small() { ends 1 "$randpack" run "$tmp/one.scene" --out "$tmp/none" --set measure.rdf.reach=500 --set measure.K.reach=500 && ends 1 "$randpack" run "$tmp/one.scene" --out "$tmp/none" --set inside=0.2 && grep -q 'give more particles, or a larger part inside' "$tmp/err" && [ ! -e "$tmp/none/summary.tsv" ]; }
tell 'a core that is too small is told' small
cube() { run one cube --set cube=1.0 && head -2 "$tmp/cube/cube-0.xyz" | grep -q 'pbc="F F F"' && awk 'NR == 2 { split($0, p, "[\" ]"); s = p[2] + 0 }
    NR > 2 { n++; for (k = 2; k < 5; k++) if ($k < 0 || $k >= s) bad++ } END { exit !(n > 100 && !bad) }' "$tmp/cube/cube-0.xyz" &&
  ends 0 "$randpack" measure "$tmp/cube/cube-0.xyz" --scene "$tmp/one.scene" --out "$tmp/cut" --set inside=0.8 \
    --set 'measure={coordination={};}' && holds cut 'v["fraction"] > 0.55 && v["fraction"] < 0.65 && v["coordination"] > 2.9 && v["coordination"] < 3.6'; }
tell 'a cube is cut from the core, and is a bounded sample' cube
rest() { run two rest --set make.mode=literal --set make.passes=6 && holds rest 'v["overlap"] < 1e-9' &&
  run one rests --set make.mode=literal --set make.passes=6 --set fraction=0.5 --set 'dilute={range="centres";part=0.3;}' --set 'measure={}' && holds rests 'v["overlap"] < 1e-9'; }
start() { refused 'the pack to start from is not periodic' "$randpack" run "$tmp/start.scene" --out "$tmp/undone"; }
printf 'dimension = 3; fraction = 0.62; make = { method = "crm"; start = "%s"; };' "$tmp/one/pack-0.xyz" > "$tmp/start.scene"
tell 'a finite pack is no start for growth' start
plan() { ends 0 "$randpack" plan "$tmp/one.scene" --set cube=0.5 && grep -q '^box.*none: a finite pack' "$tmp/out" && grep -q '^modules.* field gravity' "$tmp/out" &&
  grep -q ' profile.tsv profile-shells.tsv radial.tsv.* pack-K.xyz cube-K.xyz' "$tmp/out"; }
tell 'the plan tells of it' plan
literal() { run one literal --set make.mode=literal --set measure.histogram.radius=2.2 && holds literal 'v["growths"] == 25 && v["passes"] == 6 && v["overlap"] > 1e-6 && v["min_gap"] < 0'; }
tell 'the letter leaves overlaps, and says so' literal
cat > "$tmp/two.scene" <<'END'
dimension = 2; seed = 3; save = true;
species = ( { name = "fine"; radius = 1.0; number = 1500; }, { name = "coarse"; radius = 3.0; number = 40; } );
make = { method = "gravity"; };
measure = { coordination = {}; };
END
add() { run two add && holds add 'v["number.coarse"] == 40 && v["number.fine"] + v["destroyed"] == 1500 && v["destroyed"] > 100 && v["overlap"] < 1e-9 &&
  v["min_gap"] > -1e-9 && v["turns"] >= 200 && v["fraction"] > 0.75 && near(v["core.fine"] + v["core.coarse"], 1, 1e-9)'; }
tell 'coarse discs are added, and make room by destroying' add
mark() { run two mark --set 'species=({name="fine";radius=1.0;number=1500;},{name="coarse";radius=3.0;number=40;grow="mark";})' &&
  holds mark 'v["number.coarse"] == 40 && v["number.fine"] == 1500 && v["destroyed"] == 0 && v["turns"] >= 200 && v["overlap"] < 1e-9'; }
tell 'or are marked, and nobody is destroyed' mark
together() { run two together --set 'species=({name="fine";radius=1.0;number=1000;},{name="coarse";radius=2.0;number=250;grow="together";})' &&
  holds together 'v["number.coarse"] == 250 && v["core.coarse"] < 0.4 && v["overlap"] < 1e-9'; }
tell 'or grow together, and separate' together
law() { run two law --set 'species=({name="fine";radius=1.0;number=1000;},{name="C";radius=2.0;number=100;grow="mark";sizes={law="lognormal";spread=0.2;least=1.2;most=4.0;};})' &&
  awk '$1 == "C" { n++; if ($5 < 1.2 || $5 > 4) bad++; if ($5 != last) kinds++; last = $5 } END { exit !(n == 100 && !bad && kinds > 90) }' "$tmp/law/pack-0.xyz"; }
tell 'marked ones grow each to its own radius' law
three() { run two three --set 'species=({name="a";radius=1.0;number=2000;},{name="b";radius=2.0;number=60;},{name="c";radius=4.0;number=12;})' &&
  holds three 'v["number.a"] + v["destroyed"] >= 2000 && v["number.c"] == 12 && v["overlap"] < 1e-9'; }
tell 'three sizes are built from fine to coarse' three
apart() {
  run two apart --set gap=0.3 --set 'species=({name="a";radius=1.0;number=400;},{name="c";radius=2.0;number=20;grow="mark";sizes={law="lognormal";spread=0.2;least=1.2;most=4.0;};})' &&
  holds apart 'v["min_gap"] > 0.15 - 1e-8 && v["min_gap"] < 0.16 && v["number.a"] == 400' && cp "$tmp/apart/pack-0.xyz" "$tmp/apart.xyz" &&
  run two apart --set 'species=({name="a";radius=1.0;number=400;},{name="c";radius=2.0;number=20;grow="mark";sizes={law="lognormal";spread=0.2;least=1.2;most=4.0;};})' &&
  diff <(awk 'NR > 2 { print $1, $5 }' "$tmp/apart.xyz" | sort) <(awk 'NR > 2 { print $1, $5 }' "$tmp/apart/pack-0.xyz" | sort); }
tell 'a gap is kept, and the radii are those without it' apart
cat > "$tmp/pairs.scene" <<'END'
dimension = 3; seed = 3; save = true;
species = ( { name = "fine"; radius = 2.0; number = 4000; }, { name = "coarse"; radius = 4.0; number = 100; } );
make = { method = "gravity"; };
measure = { coordination = { tolerance = 1e-7; }; partials = { scale = "r"; step = 0.1; reach = [5.0]; tolerance = 1e-7;
  window = 4.0; extrema = ( { pair = "fine-coarse"; peak = [3.5, 5.0]; } ); }; };
END
around() { # REACH A B: how many A are centres of so wide a window, in radii, and how many B one has about it
  awk -v reach="$1" -v a="$2" -v b="$3" 'NR == 2 { match($0, /open=[0-9.e+-]+/); core = 0.6 * substr($0, RSTART + 5, RLENGTH - 5) - 2 * reach
      match($0, /Lattice="[0-9.e+-]+/); half = substr($0, RSTART + 9, RLENGTH - 9) / 2 }
    NR > 2 { x[NR] = $2; y[NR] = $3; z[NR] = $4; who[NR] = $1 }
    END { for (i = 3; i <= NR; i++) if (who[i] == a && sqrt((x[i] - half) ^ 2 + (y[i] - half) ^ 2 + (z[i] - half) ^ 2) <= core) {
        centres++; for (j = 3; j <= NR; j++) n += i != j && who[j] == b && (x[i] - x[j]) ^ 2 + (y[i] - y[j]) ^ 2 + (z[i] - z[j]) ^ 2 < (2 * reach) ^ 2 }
      printf "%d %.12g\n", centres, centres ? n / centres : 0 }' "$tmp/pairs/pack-0.xyz"; }
contacts() { run pairs pairs && fine=$(around 4.0000004 fine none) && coarse=$(around 4.0000004 coarse none) && fine=${fine% *} coarse=${coarse% *} && [ "$fine" -gt 200 ] && [ "$coarse" -gt 4 ] &&
  holds pairs "near($fine * (v[\"coordination.fine-fine\"] + v[\"coordination.fine-coarse\"]) + $coarse * (v[\"coordination.coarse-fine\"] + v[\"coordination.coarse-coarse\"]), ($fine + $coarse) * v[\"coordination\"], 1e-6)"; }
tell 'contacts of all pairs of species are all contacts' contacts
numbers() { holds pairs 'v["number.fine"] + v["number.coarse"] == v["number"] && v["number.coarse"] == 100 && near(v["volume.fine"] + v["volume.coarse"], 1, 1e-9) && v["nearest.coarse-fine"] < 0.01 &&
  v["least_gap.fine-fine"] > -1e-7 && !("contact.fine-fine" in v) && !("contact_first_bin.fine-coarse" in v)' &&
  [ "$(cut -f1 "$tmp/pairs/summary.tsv" | sort | uniq -d)" = '' ]; }
tell 'there is no contact value where particles touch, and each number stands once' numbers
about() {
  awk -v n="$(awk -F'\t' '!/^#/ && !/^R/ { n = $8 } END { print n }' "$tmp/pairs/partial.fine-coarse.tsv")" -v want="$(around 5 fine coarse)" \
    'BEGIN { split(want, w, " "); exit !(w[1] > 100 && w[2] > 0.5 && (n / w[2] - 1) ^ 2 < 1e-18) }' || { echo 'n about fine'; return 1; }
  for q in 'fine fine fine-fine 2' 'fine coarse fine-coarse 2' 'coarse fine fine-coarse 4' 'coarse coarse coarse-coarse 2'; do
    read -r a b table column <<< "$q"
    awk -F'\t' -v c="$column" -v m="$(value "window_mean.$a-$b" "$tmp/pairs")" -v want="$(around 4 "$a" "$b")" '!/^#/ && !/^n/ { s += $c; t += $1 * $c }
      END { split(want, w, " "); exit !(w[1] > 4 && (s - 1) ^ 2 < 1e-18 && (t - m) ^ 2 < 1e-18 && (m - w[2]) ^ 2 < 1e-18) }' "$tmp/pairs/window.$table.tsv" || { echo "window $a-$b"; return 1; }; done; }
tell 'numbers about a species, and windows on it, are those of the file' about
again() {
  ends 0 "$randpack" measure "$tmp/pairs/pack-0.xyz" --scene "$tmp/pairs.scene" --out "$tmp/read" || return 1
  for p in fine-fine fine-coarse coarse-coarse; do for t in partial window; do
    cmp -s <(grep -v '^#' "$tmp/pairs/$t.$p.tsv") <(grep -v '^#' "$tmp/read/$t.$p.tsv") || { echo "$t.$p differs"; return 1; }; done; done
  diff <(grep -E '^(coord|near|least|window|peak|number|volume|core)' "$tmp/pairs/summary.tsv") <(grep -E '^(coord|near|least|window|peak|number|volume|core)' "$tmp/read/summary.tsv"); }
tell 'pairs of species of a file are those of the scene' again
peaks() { run pairs peaks --set realizations=2 && holds peaks 'v["peak1_R.fine-coarse"] > 4 && v["peak1_R.fine-coarse"] < 5 && v["peak1_g.fine-coarse"] > 1.2 && v["peak1_g.fine-coarse"] < 2'; }
tell 'with peaks' peaks
few() { ends 1 "$randpack" run "$tmp/pairs.scene" --out "$tmp/few" --set 'measure={partials={reach=[4.0,4.0,12.0];};}' && grep -q 'give more particles, or a larger part inside' "$tmp/err" && [ ! -e "$tmp/few/summary.tsv" ]; }
tell 'a species without centres is told' few
shares() { run two none --set 'species=({name="fine";radius=1.0;number=500;},{name="coarse";radius=3.0;number=0;})' && holds none 'v["number.coarse"] == 0 && v["number"] == 500' &&
  run two all --set 'species=({name="fine";radius=1.0;number=0;},{name="coarse";radius=1.5;number=100;grow="mark";})' && holds all 'v["number.fine"] == 0 && v["number.coarse"] == 100'; }
tell 'no coarse ones and nothing else are packs too' shares
thin() { run one thin --set fraction=0.3 --set 'dilute={}' --set 'measure={nearest={reach=4.0;step=0.1;};coordination={};}' && holds thin 'near(v["fraction"], 0.3, 1e-12) && near(v["fraction_dense"], 0.6, 0.02) && v["min_gap"] > -1e-9 && v["aims"] >= 1'; }
tell 'a pack is diluted to its very fraction' thin
undone() { ends 2 "$randpack" run "$tmp/one.scene" --out "$tmp/undone" --set fraction=0.7 --set 'dilute={}' && [ ! -e "$tmp/undone/summary.tsv" ]; }
tell 'and not to a higher one' undone
of_file() { ends 2 "$randpack" measure "$tmp/one/pack-0.xyz" --scene "$tmp/one.scene" --out "$tmp/undone" --set 'measure={pressure={};}' && grep -q 'measure.pressure cannot be used with finite packs' "$tmp/err"; }
tell 'a finite file has no pressure' of_file
alone() { run one single --set 'species=({radius=2.0;number=1;})' --set inside=1.0 --set 'measure={nearest={reach=0.5;step=0.1;};}' && grep -q '^min_gap	inf' "$tmp/single/summary.tsv" &&
  ! grep -q '^nearest' "$tmp/single/summary.tsv" && holds single 'v["fraction"] == 1 && v["rim"] == 1 && v["centres"] == 1'; }
tell 'a single one has nobody near, no image of its own either' alone
edge() { local far near
  read -r far near < <(awk -v r="$(value reach "$tmp/one")" 'BEGIN { print r + 0.1, r - 0.1 }')
  run one near --set "measure={rdf={reach=$near;};}" && ends 1 "$randpack" run "$tmp/one.scene" --out "$tmp/far" --set "measure={rdf={reach=$far;};}" &&
  grep -q 'measure.rdf needs a centre in the core, R = .* or more from its edge, and there is none, the deepest is at R = ' "$tmp/err"; }
tell 'pairs are counted as far as the core reaches, and no farther' edge
inner() { run one inner --set inside=0.4 --set fraction=0.3 --set 'dilute={}' &&
  holds inner 'near(v["fraction"], 0.3, 1e-12) && near(v["reach"], 0.4 * v["rim"], 1e-9) && v["fraction_dense"] > 0.58'; }
tell 'the fraction of a dilution is that of the core that is asked for' inner
apart() { ! cmp -s <(tail -n +3 "$tmp/one/pack-0.xyz") <(tail -n +3 "$tmp/one/pack-1.xyz"); }
tell 'realizations differ' apart
largest() { awk 'NR == 2 { split($0, p, "[\" ]"); sub(/.*open=/, ""); print p[2], $1 }' "$tmp/cube/cube-0.xyz" > "$tmp/side" &&
  awk -v s="$(cat "$tmp/side")" -v rim="$(value rim "$tmp/cube")" -v open="$(head -2 "$tmp/cube/pack-0.xyz" | sed -n 's/.*open=\([^ ]*\).*/\1/p')" \
    'BEGIN { split(s, c, " "); exit !(open > 0 && (c[1] / (1.2 * open / sqrt(3)) - 1) ^ 2 < 1e-20 && (c[2] / c[1] - 0.5) ^ 2 < 1e-20) }'; }
tell 'the cube is the largest in the core' largest
angles() { awk -F'\t' '/^#/ || /^c/ { next } { n++; if (($1 - (n - 0.5) / 5) ^ 2 > 1e-20) bad++; sum += $2 } END { exit !(n == 5 && !bad && sum > 0) }' "$tmp/one/radial.tsv"; }
tell 'directions stand at the middles of their bins' angles
mixed() { run two mixed --set 'species=({name="a";radius=1.0;number=300;},{name="b";radius=2.0;number=50;grow="together";sizes={law="lognormal";spread=0.2;least=1.2;most=4.0;};})' &&
  awk '$1 == "a" { if ($5 != 1) bad++ } $1 == "b" { n++; if ($5 < 1.2 || $5 > 4) bad++; if ($5 != last) kinds++; last = $5 } END { exit !(n == 50 && !bad && kinds > 40) }' "$tmp/mixed/pack-0.xyz"; }
tell 'some of one radius and some by a law grow together' mixed
tell 'what comes after the letter is parted all the same' rest
# Combinations of a sweep that have the same base are what they are alone; so are those that have not.
kin() { # kin KEY VALUE VALUE KEY VALUE VALUE
  local set=(--set save=false --set 'species.[0].number=500')
  run two kin "${set[@]}" --set "sweep=({key=\"$1\";values=($2,$3);},{key=\"$4\";values=($5,$6);})" || return 1
  local a b at
  for a in "$2" "$3"; do for b in "$5" "$6"; do
    at=$(tr -d '"' <<<"@$a@$b")
    run two alone "${set[@]}" --set "$1=$a" --set "$4=$b" || return 1
    awk -F'\t' -v at="$at" '/^(#|quantity)/ { next } FNR == NR { alone[$1] = $2; n++; next }
      sub(at "$", "", $1) && $1 in alone { both++; other += alone[$1] != $2 } END { exit !(n > 20 && both == n && !other) }' \
      "$tmp/alone/summary.tsv" "$tmp/kin/summary.tsv" || { echo "$at is not what it is alone"; return 1; }
  done; done
}
tell 'a base serves all that are added to it or marked in it' kin 'species.[1].grow' '"add"' '"mark"' 'species.[1].number' 4 8
tell 'who are grown otherwise have a base of their own' kin make.step 0.3 0.9 'species.[1].number' 4 8
exit $failed
