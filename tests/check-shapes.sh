#!/bin/bash
# tests/check-shapes.sh: shapes in a scene, in a pack, in its file, and measured from it.
. tests/tell.sh
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
cat > "$tmp/some.scene" <<'END'
dimension = 2; seed = 3; realizations = 2; fraction = 0.4; save = true;
species = ( { name = "P"; radius = 2.5; number = 40; shape = { kind = "polygon"; sides = 5; }; },
            { name = "Q"; radius = 1.5; number = 10; shape = { kind = "polygon"; vertices = ([0, 0], [3, 0], (1, 2.5)); }; },
            { name = "S"; number = 20; shape = { kind = "superellipse"; aspect = 1.5; m = 1.7; };
              sizes = { law = "power"; exponent = 0.5; least = 1.0; most = 2.0; }; },
            { name = "D"; radius = 1.0; number = 5; } );
make = { method = "points"; };
measure = { rdf = { reach = 5.0; }; K = { reach = 5.0; }; histogram = {}; nearest = {}; order = {}; I = { reach = 4.0; };
            quotients = { steps = [0.5]; }; };
END
made() { run some one && [ "$(value reduced_density "$tmp/one")" = 0.4 ] && [ -z "$(value fraction "$tmp/one")" ] && [ "$(value number "$tmp/one")" = 75 ]; }
tell 'a pack of four species, three of them with shapes, has its fraction' made
discs() { sed 's/shape = {[^}]*};//' "$tmp/some.scene" > "$tmp/discs.scene" && run discs discs &&
  cmp -s <(awk 'NR > 2 { print $1, $2, $3, $5 }' "$tmp/one/pack-1.xyz") <(awk 'NR > 2 { print $1, $2, $3, $5 }' "$tmp/discs/pack-1.xyz") &&
  cmp -s <(grep -v '^#' "$tmp/one/K.tsv") <(grep -v '^#' "$tmp/discs/K.tsv") && ! grep -q angle "$tmp/discs/pack-0.xyz"; }
tell 'discs of the seed stand at the same places, and have no angle' discs
overlaps() { awk -v a="$(value min_gap "$tmp/one")" -v b="$(value min_gap "$tmp/discs")" 'BEGIN { exit !(a < -0.05 && a != b) }'; }
tell 'its least gap is that of the shapes' overlaps
again() { ends 0 "$randpack" measure "$tmp"/one/pack-{0,1}.xyz --scene "$tmp/some.scene" --out "$tmp/again" &&
  for t in rdf K histogram nearest I quotients; do
    diff <(grep -v '^#' "$tmp/one/$t.tsv") <(grep -v '^#' "$tmp/again/$t.tsv") > "$tmp/diff" || { echo "$t differs"; return 1; }
  done && diff <(grep -v '^#' "$tmp/one/summary.tsv") <(grep -v '^#' "$tmp/again/summary.tsv"); }
tell 'measured from its file it gives the same tables' again
first() { # FILE FROM TO [LEAST]: the first bin, or the first in which g is above LEAST
  printf 'dimension = 2; measure = { rdf = { reach = 5.0; }; };\n' > "$tmp/file.scene" &&
    ends 0 "$randpack" measure "$1" --scene "$tmp/file.scene" --out "$tmp/file" &&
    awk -v from="$2" -v to="$3" -v least="${4:--1}" '$1 + 0 > 0 && $2 > least { exit !($1 > from && $1 < to) }' "$tmp/file/rdf.tsv"
}
hard() { run some hard --set realizations=1 --set fraction=0.3 --set 'make={method="sequential";}' && first "$tmp/hard/pack-0.xyz" 0.6 2 0; }
tell 'g of a file begins where centres of shapes can be, nearer than discs of equal area' hard
begins() { awk '$1 + 0 > 0 { exit !($1 > 0.6 && $1 < 0.7) }' "$tmp/hard/rdf.tsv"; }
tell 'of packs that the scene makes, its first bin is there' begins
tell 'and at 0 if the shapes overlap' first "$tmp/one/pack-0.xyz" 0 0.02
bytes() { "$randpack" plan "$tmp/$1.scene" | grep -qx "store	$2 bytes a particle"; }
tell 'the plan counts eight bytes an angle' bytes some 34
tell 'and none of discs' bytes discs 26

round() { run some round --set 'measure={shapes={};}' && [ "$(value roundness.P "$tmp/round")" = 0.929949603999 ] &&
  [ "$(value as_round.P "$tmp/round")" = 1.88346995392 ] && [ "$(value as_round.D "$tmp/round")" = 1 ]; }
tell 'how round they are, and the ellipse that is as round' round
needle() { run some needle --set 'measure={shapes={};}' --set 'species.[2].shape.aspect=1000.0' --set 'species.[2].shape.m=0.5' && [ -z "$(value as_round.S "$tmp/needle" | grep -v nan)" ]; }
tell 'no ellipse is as round as a long rhombus' needle

# What presupposes balls is refused, of a scene (tests/bad) and of a file, each in one line.
of_file() { refused "$1" "$randpack" measure "$2" --scene "$tmp/some.scene" --out "$tmp/new" --set "measure={$3={};}"; }
for what in contact pressure coordination partials; do
  tell "$what of shapes from a file" of_file "some.scene:--set: measure.$what needs balls, but a species has a shape; leave it out" \
    "$tmp/one/pack-0.xyz" "$what$([ $what = partials ] && printf '={reach=[3.0];};rdf')"
done
sed '2s/pbc="T T F"/pbc="F F F" dimension=2/' "$tmp/one/pack-0.xyz" > "$tmp/finite.xyz"
tell 'a finite pack with shapes' of_file "finite.xyz: a finite pack with shapes; give a periodic one" "$tmp/finite.xyz" rdf
printf 'dimension = 2; fraction = 0.6; make = { method = "crm"; start = "%s"; };\n' "$tmp/one/pack-0.xyz" > "$tmp/grow.scene"
tell 'growth from a pack of shapes' refused 'grow.scene:1: the pack to start from has shapes, but growth needs balls; give' \
  "$randpack" plan "$tmp/grow.scene"
tell 'nothing was written' test ! -e "$tmp/new"
keys() { "$randpack" help > "$tmp/help" && for key in kind sides vertices aspect m; do
  grep -q "^  species.shape.$key  " "$tmp/help" || { echo "$key"; return 1; }; done; }
tell 'help names the keys of a shape' keys
exit $failed
