#!/bin/bash
# tests/check-corners.sh: corners of makers and measures: what is refused in time, what has no error, what ends.
. tests/tell.sh
one() { # one NAME WORDS: a scene
  printf '%s\n' "$2" > "$tmp/$1.scene"
}
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$1" "${@:2}"; }
error() { awk -F'\t' -v q="$1" '$1 == q { print $3 }' "$2/summary.tsv"; }

# ---- makers
one single 'dimension = 3; species = ( { radius = 1.0; number = 1; } ); fraction = 0.2; make = { method = "crm"; };'
tell 'a single particle grows' run single
tell 'and has no Gamma, since it does not move' test -z "$(value gamma "$tmp/single")"
tell 'it cannot collide afterwards' refused 'single.scene:--set: a single particle has no other to collide with; leave it out' \
  "$randpack" run "$tmp/single.scene" --set make.rest=5
one start 'dimension = 3; species = ( { radius = 1.0; number = 100; } ); fraction = "max"; make = { method = "crm"; start = "rsa"; start_fraction = 0.2; growth = 0.2; };'
tell 'growth to jamming from random addition' run start --set make.pressure=1e5
begun() { ends 1 "$randpack" run "$tmp/start.scene" --set make.start_fraction=0.45 --out "$tmp/new" && grep -q ' of 100 ' "$tmp/err"; }
tell 'begins at the start fraction, which may be too high for addition' begun
one wide 'dimension = 2; side = 1e9; species = ( { radius = 1.0; } ); fraction = 0.5; make = { method = "penetrable"; };'
tell 'more grains than there can be' timeout 60 bash -c ". tests/tell.sh; refused ';' '$randpack' plan '$tmp/wide.scene'"
one marked 'dimension = 2; species = ( { name = "A"; radius = 1.0; number = 0; }, { name = "B"; radius = 2.0; number = 30; grow = "mark"; } );
fraction = 0.5; make = { method = "gravity"; }; dilute = {};'
tell 'a dilution without a fine particle' refused 'the pack has no particle of the first species' "$randpack" run "$tmp/marked.scene" --out "$tmp/new"
one budget 'dimension = 2; species = ( { radius = 1.0; number = 20; shape = { kind = "polygon"; sides = 4; }; } ); fraction = 0.85;
make = { method = "compression"; each = 1000; budget = 3.0; };'
spent() { ends 1 "$randpack" run "$tmp/budget.scene" --out "$tmp/new" && grep -q ' 3 sweeps reached a fraction' "$tmp/err"; }
tell 'not more sweeps than were allowed' spent
round() { # superellipses next to an ellipse are ellipses
  one "$1" "dimension = 2; species = ( { radius = 1.0; number = 30; shape = { kind = \"superellipse\"; aspect = 2.0; m = $1; }; } );
fraction = 0.3; make = { method = \"sequential\"; }; measure = { covered = {}; };"
  run "$1"
}
tell 'an exponent just above that of an ellipse' round 1.0000000000000002
tell 'and just below' round 0.9999999999999998

# ---- measures
one central 'dimension = 3; species = ( { radius = 1.0; number = 500; } ); fraction = 0.2; make = { method = "rsa"; };
measure = { rdf = { step = 3.0; reach = 8.0; estimator = "central"; }; };'
tell 'a central bin with its middle at contact' run central
tell 'that cannot begin below 0' refused 'step of measure.rdf is 5, and with the estimator central the first bin would begin below R = 0; give at most 4' \
  "$randpack" run "$tmp/central.scene" --set measure.rdf.step=5.0 --out "$tmp/new"
one right 'dimension = 3; species = ( { radius = 1.0; number = 50; } ); fraction = 0.2; make = { method = "points"; }; realizations = 4;
measure = { rdf = { step = 0.1; reach = 1.0; estimator = "right"; peaks = [0.52, 0.53]; }; };'
zero() { run right && [ "$(awk -F'\t' '$1 == 0 { print $2 }' "$tmp/right/rdf.tsv")" = nan ]; }
tell 'the right quotient does not exist at 0' zero
tell 'an interval without a parabola has no height' test "$(value peak1_g "$tmp/right")" = nan
one jump 'dimension = 3; species = ( { name = "A"; radius = 1.0; number = 200; }, { name = "B"; radius = 1.0; number = 100; } ); fraction = 0.2; make = { method = "rsa"; };
measure = { K = { step = 0.1; reach = 2.5; }; };'
tell 'K has a jump of hard balls of one size' run jump
tell 'which is a number' test -n "$(value K_jump "$tmp/jump")"
no_jump() { run jump --set "$@" && [ -z "$(value K_jump "$tmp/jump")" ]; }
tell 'but not of points, which are nearer' no_jump make='{method="points";}'
tell 'nor of two sizes' no_jump 'species=({name="A";radius=1.0;number=200;},{name="B";radius=0.5;number=100;})'
tell 'nor of many' no_jump 'species=({name="A";radius=1.0;number=300;sizes={law="lognormal";spread=0.3;};})'
tell 'nor of shapes' no_jump dimension=2 --set make='{method="sequential";}' --set 'species=({name="A";radius=1.0;number=300;shape={kind="polygon";sides=4;};})'
one few 'dimension = 3; species = ( { radius = 1.0; number = 50; } ); fraction = 0.2; make = { method = "points"; }; realizations = 9;
measure = { rdf = { step = 0.1; reach = 1.0; }; };'
tell 'nine packs are measured' run few
tell 'but have no range' test "$(value range "$tmp/few")" = nan
ten() { run few --set realizations=10 && [ "$(value range "$tmp/few")" != nan ]; }
tell 'ten have one' ten
one lonely 'dimension = 3; species = ( { radius = 1.0; number = 1; } ); fraction = 0.001; make = { method = "rsa"; }; measure = { approach = {}; };'
tell 'a curve of no time' run lonely
one late 'dimension = 2; side = 12.0; species = ( { radius = 1.0; } ); fraction = "max"; realizations = 12; make = { method = "rsa"; }; measure = { approach = {}; };'
slopes() { # some of these have one late pack alone, whose slope has no error
  local seed
  for seed in $(seq 12); do
    run late --set seed="$seed" || return 1
    [[ $(error approach_exponent "$tmp/late") != @(-nan|0) ]] || { echo "seed $seed"; return 1; }
  done
}
tell 'a slope without an error' slopes
one both 'dimension = 3; species = ( { radius = 1.0; number = 100; } ); fraction = 0.3; make = { method = "rsa"; };
shake = { rule = "newton"; sweeps = 4; samples = 2; }; measure = { contact = {}; };'
tell 'a pressure between samples' run both
tell 'has not the error of another' test "$(error shaken.Z "$tmp/both")" = nan

# ---- several packs
head='Lattice="10 0 0 0 10 0 0 0 10" Properties=species:S:1:pos:R:3:radius:R:1 pbc="T T T"'
printf '3\n%s\nA 1 1 1 1\nA 3 1 1 0.5\nA 7 7 7 1\n' "$head" > "$tmp/pa.xyz"
printf '3\n%s\nA 1 1 1 1\nA 3 1 1 0.8\nA 7 7 7 0.9\n' "$head" > "$tmp/pb.xyz"
one files 'dimension = 3; measure = { rdf = { step = 0.5; reach = 4.0; peaks = [2.0, 3.0]; }; };'
mean() { # of two packs with other contacts: the mean of the two curves, in the same bins
  ends 0 "$randpack" measure "$tmp/$1.xyz" --scene "$tmp/files.scene" --out "$tmp/$1" &&
    ends 0 "$randpack" measure "$tmp/$2.xyz" --scene "$tmp/files.scene" --out "$tmp/$2" &&
    ends 0 "$randpack" measure "$tmp/$1.xyz" "$tmp/$2.xyz" --scene "$tmp/files.scene" --out "$tmp/$1$2" || return 1
  paste "$tmp/$1/rdf.tsv" "$tmp/$2/rdf.tsv" "$tmp/$1$2/rdf.tsv" |
    awk -F'\t' '$1 + 0 > 0 { n++; all += $5; bad += $1 != $4 || $1 != $7 || (($2 + $5) / 2 - $8) ^ 2 > 1e-20 } END { exit bad || n != 8 || all == 0 }'
}
tell 'g of several packs is averaged in the same bins' mean pa pb
tell 'in any order' mean pb pa
one own 'dimension = 3; species = ( { name = "A"; radius = 1.0; number = 200; } ); fraction = 0.3; make = { method = "crm"; };
shake = { rule = "metropolis"; sweeps = 2; }; measure = { rdf = { step = 0.5; reach = 4.0; }; }; save = true;'
again() { run own && ends 0 "$randpack" measure "$tmp/own/pack-0.xyz" --scene "$tmp/own.scene" --out "$tmp/again"; }
tell 'a pack is measured by the scene that has shaken it' again
same() { diff <(grep '^[0-9]' "$tmp/again/rdf.tsv" | cut -f 1,2) <(grep '^[0-9]' "$tmp/own/shaken.rdf.tsv" | cut -f 1,2); }
tell 'with the same g' same
awk 'NR == 3 { $NF = 0.7 } { print }' "$tmp/own/pack-0.xyz" > "$tmp/other.xyz"
tell 'bins that begin elsewhere are not averaged' refused 'other.xyz: rdf begins at 0.25, and at 2.25 in' "$randpack" measure "$tmp/own/pack-0.xyz" "$tmp/other.xyz" \
  --scene "$tmp/own.scene" --out "$tmp/new"
for z in T F; do
  { echo 60; echo "Lattice=\"20 0 0 0 20 0 0 0 20\" Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"F F $z\""
    awk 'BEGIN { for (i = 0; i < 60; i++) printf "A %g %g 0 1\n", 1 + 2.3 * (i % 8), 1 + 2.3 * int(i / 8) }'; } > "$tmp/discs-$z.xyz"
done
one flat 'dimension = 2; measure = { nearest = {}; };'
discs() { for z in T F; do ends 0 "$randpack" measure "$tmp/discs-$z.xyz" --scene "$tmp/flat.scene" --out "$tmp/flat-$z" || return 1; done; cmp "$tmp"/flat-[TF]/summary.tsv; }
tell 'discs that repeat in no direction of their plane are a finite pack' discs
one shaken 'dimension = 3; species = ( { name = "A"; radius = 1.0; number = 10; } ); fraction = 0.2; make = { method = "rsa"; };
shake = { rule = "metropolis"; sweeps = 2; }; measure = { approach = {}; };'
tell 'a curve of the making, of packs that are shaken' run shaken
exit $failed
