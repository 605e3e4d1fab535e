#!/bin/bash
# tests/check-foreign.sh: packs of several files and species. The numbers of tests/foreign are known by brute force; species are
# matched by name; no order of lines and no way of writing changes a table; what we wrote is measured again as it was.
. tests/tell.sh
from=tests/foreign
cat > "$tmp/o.scene" <<'END'
dimension = 3;
measure = { rdf = { step = 0.5; reach = 3.0; }; nearest = {}; partials = { reach = [3.0]; step = 0.25; }; };
END
cat > "$tmp/p.scene" <<'END'
dimension = 3;
measure = { rdf = { step = 0.5; reach = 4.0; }; nearest = {}; K = { step = 1.0; reach = 4.0; }; coordination = { tolerance = 0.05; }; };
END
cat > "$tmp/m.scene" <<'END'
dimension = 3;
measure = { rdf = { step = 0.5; reach = 4.5; }; nearest = {}; };
END
measure() { # measure OUT SCENE PACK... : the tables without what tells the fingerprint
  local out=$tmp/$1 scene=$tmp/$2.scene
  shift 2
  rm -rf "$out"
  ends 0 "$randpack" measure "$@" --scene "$scene" --out "$out" && sed -i '/^# \(randpack\|scene\)/d' "$out"/*
}
near() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a - b < 1e-5 * b && b - a < 1e-5 * b) }' || { echo "$1, not $2"; return 1; }; }
turned() { { head -2 "$1"; tail -n +3 "$1" | tac; } > "$2"; }
shuffled() { { head -2 "$1"; tail -n +3 "$1" | sort -k4; } > "$2"; }

# One pack, known by brute force.
spheres() {
  measure m m $from/spheres.xyz && near "$(value fraction "$tmp/m")" 0.251327 && near "$(value min_gap "$tmp/m")" 0.00882212 &&
    near "$(value nearest "$tmp/m")" 2.158182 && near "$(awk '$1 == 2.25 { print $2 }' "$tmp/m/rdf.tsv")" 1.46817
}
tell 'sixty spheres, known by brute force' spheres

# The order of lines.
sizes() {
  measure p p $from/sizes.xyz && turned $from/sizes.xyz "$tmp/t.xyz" && measure t p "$tmp/t.xyz" && diff -r "$tmp/p" "$tmp/t" &&
    shuffled $from/sizes.xyz "$tmp/t.xyz" && measure t p "$tmp/t.xyz" && diff -r "$tmp/p" "$tmp/t"
}
tell 'two hundred sizes, whatever the order of their lines' sizes
# Those that sample particles, or sum them with rounding, too.
printf '%s\n' 'dimension = 2; seed = 4; fraction = 0.4; save = true; make = { method = "points"; }; measure = { nearest = {}; };' \
  'species = ( { name = "P"; radius = 1.0; number = 40; shape = { kind = "polygon"; sides = 5; }; }, { name = "D"; radius = 0.5; number = 30; } );' > "$tmp/thrown.scene"
printf '%s\n' 'dimension = 2; measure = { surface = { points = 500.0; }; pores = { points = 500.0; }; cluster = { points = 500.0; };' \
  'S2 = { step = 0.5; reach = 2.0; }; S3 = { step = 1.0; reach = 2.0; samples = 1024.0; }; chords = { lines = 100.0; }; structure = { reach = 4.0; }; covered = {}; };' > "$tmp/all.scene"
sampled() {
  ends 0 "$randpack" run "$tmp/thrown.scene" --out "$tmp/thrown" && measure all all "$tmp/thrown/pack-0.xyz" &&
    turned "$tmp/thrown/pack-0.xyz" "$tmp/t.xyz" && measure t all "$tmp/t.xyz" && diff -r "$tmp/all" "$tmp/t" &&
    shuffled "$tmp/thrown/pack-0.xyz" "$tmp/t.xyz" && measure t all "$tmp/t.xyz" && diff -r "$tmp/all" "$tmp/t"
}
tell 'nor does what samples particles know the order of lines' sampled
tell 'the unit is told, by name and value' grep -q '^# unit of length a = 0.967512484, the radius of grain$' "$tmp/p/summary.tsv"
species() {
  turned $from/large-small-2.xyz "$tmp/t.xyz" && sed -i '2s/$/ randpack_species="S:1 L:2"/' "$tmp/t.xyz" &&
    measure a o $from/large-small.xyz $from/large-small-2.xyz && measure b o $from/large-small.xyz "$tmp/t.xyz" && diff -r "$tmp/a" "$tmp/b" &&
    near "$(value nearest "$tmp/a")" 1.19796 && near "$(value min_gap "$tmp/a")" 0.00061469
}
tell 'two packs of two species, the lines of the second in another order' species
bins() {
  near "$(awk '/^[0-9]/ { printf "%.4f", $3; exit }' "$tmp/a/partial.L-L.tsv")" 1.0734 &&
    near "$(awk '/^[0-9]/ { printf "%.4f", $3; exit }' "$tmp/a/partial.S-S.tsv")" 1.5897
}
tell 'and the first bins of their partials' bins
two() {
  turned $from/two.xyz "$tmp/t.xyz" && measure a o $from/two.xyz $from/two.xyz && measure b o $from/two.xyz "$tmp/t.xyz" &&
    diff -r "$tmp/a" "$tmp/b" && near "$(value volume.L "$tmp/a")" 0.888889
}
tell 'a pack twice, the second time with its two lines exchanged' two
tell 'a pack of other species' refused "$from/other.xyz: has other species than $from/two.xyz, no L; measure them separately" \
  "$randpack" measure $from/two.xyz $from/other.xyz --scene "$tmp/o.scene" --out "$tmp/new"
tell 'and the other way round' refused "$from/two.xyz: has other species than $from/other.xyz, also L; measure" \
  "$randpack" measure $from/other.xyz $from/two.xyz --scene "$tmp/o.scene" --out "$tmp/new"
tell 'nothing was written' test ! -e "$tmp/new"

# Packs that overlap: by a file's last digits they are hard, by more they are not.
cat > "$tmp/h.scene" <<'END'
dimension = 3;
measure = { rdf = { step = 0.5; reach = 4.5; }; partials = { reach = [3.0]; step = 0.25; }; };
END
cat > "$tmp/g.scene" <<'END'
dimension = 3;
measure = { rdf = { step = 0.5; reach = 4.5; }; S2 = { method = "fft"; step = 0.5; reach = 2.0; points = 1e5; }; };
END
spheres_at() { # six spheres of radius 1, of which the last two are at 7.5 and here
  printf '6\nLattice="10 0 0 0 10 0 0 0 10" Properties=species:S:1:pos:R:3:radius:R:1\n'
  printf 'A %s 1\n' '1 1 1' '5 5 1' '1 5 5' '5 1 5' '7 7.5 7' "7 $1 7"
}
rounded() {
  spheres_at 9.499999 > "$tmp/round.xyz" && spheres_at 9.49 > "$tmp/deep.xyz" && spheres_at 9.5 > "$tmp/touch.xyz" &&
    measure round h "$tmp/round.xyz" && near "$(value fraction "$tmp/round")" 0.0251327412 && [ -z "$(value reduced_density "$tmp/round")" ]
}
tell 'what overlaps by the last digit of a file is hard' rounded
tell 'what overlaps by more is not, and the pair is named' refused \
  "deep.xyz: particles 5 and 6 overlap by 0.01 of the smallest radius, and measure.partials needs hard particles; relax them, or leave it out of" \
  "$randpack" measure "$tmp/deep.xyz" --scene "$tmp/h.scene" --out "$tmp/new"
deep() {
  measure deep g "$tmp/deep.xyz" && [ -z "$(value fraction "$tmp/deep")" ] && near "$(value reduced_density "$tmp/deep")" 0.0251327412 &&
    [ "$(awk '/^[0-9]/ { print $1; exit }' "$tmp/deep/rdf.tsv")" = 0.25 ] && [ "$(value min_gap "$tmp/deep")" = -0.005 ]
}
tell 'others take it: g from 0, and a reduced density' deep
tell 'packs of which some overlap' refused "deep.xyz: particles overlap, and none do in $tmp/touch.xyz; measure them separately" \
  "$randpack" measure "$tmp/touch.xyz" "$tmp/deep.xyz" --scene "$tmp/g.scene" --out "$tmp/new"
both() { sed 's/rdf = { step = 0.5/rdf = { step = 0.3/' "$tmp/g.scene" > "$tmp/g3.scene" && measure both g3 "$tmp/deep.xyz" "$tmp/touch.xyz" && [ "$(value realizations "$tmp/both")" = 2 ] && near "$(value reduced_density "$tmp/both")" 0.0251327412 &&
  awk '/^[0-9]/ && $1 < 1.5 { n += $2 == 0 } END { exit n != 5 }' "$tmp/both/rdf.tsv" && [ "$(awk '/^[0-9]/ { print $1; exit }' "$tmp/both/rdf.tsv")" = 0.15 ]; }
tell 'unless the first of them does' both

# Two discs on one another are one, and their bounds are those of what they cover.
cat > "$tmp/b.scene" <<'END'
dimension = 2;
measure = { covered = {}; bounds = { pixels = 40; conductivity = [1.0, 10.0]; method = "field"; }; };
END
sed 's/method = "field";//' "$tmp/b.scene" > "$tmp/best.scene"
discs_at() {
  printf '%d\nLattice="5 0 0 0 4 0 0 0 2" pbc="T T F" Properties=species:S:1:pos:R:3:radius:R:1\n' $#
  printf 'A %s 0 1\n' "$@"
}
twins() {
  discs_at '1 1' '2.1 2.9' > "$tmp/pair.xyz" && discs_at '1 1' '1 1' '2.1 2.9' > "$tmp/three.xyz" &&
    measure pair b "$tmp/pair.xyz" && measure three b "$tmp/three.xyz" && near "$(value covered "$tmp/three")" 0.31415927 || return 1
  for q in zeta2 eta2; do [ "$(value $q "$tmp/pair")" = "$(value $q "$tmp/three")" ] || return 1; done
  awk -v a="$(value conductivity_lower "$tmp/pair")" -v b="$(value conductivity_lower "$tmp/three")" 'BEGIN { exit !(a > 1 && (a - b) ^ 2 < 1e-6) }' &&
    measure best best "$tmp/three.xyz" && [ "$(value zeta2 "$tmp/best")" = "$(value zeta2 "$tmp/three")" ]
}
tell 'bounds of discs that overlap are those of what they cover' twins

# So few pixels that no share is known.
few() {
  ends 2 "$randpack" measure "$tmp/pair.xyz" --scene "$tmp/b.scene" --set measure.bounds.pixels=2 --out "$tmp/new" &&
    grep -q 'pair.xyz: too few pixels: the field gives zeta2 = .* with the error .*; give more measure.bounds.pixels' "$tmp/err"
}
tell 'and with few pixels there are none' few

# Several packs in a file are as many files.
frames() {
  cat $from/large-small.xyz $from/large-small-2.xyz > "$tmp/both.xyz"
  measure a o $from/large-small.xyz $from/large-small-2.xyz && measure b o "$tmp/both.xyz" && diff -r "$tmp/a" "$tmp/b" &&
    [ "$(value realizations "$tmp/b")" = 2 ]
}
tell 'two packs in one file' frames

# Names that are an index: what is told of each is told, but not of each pair.
index() {
  awk 'NR > 2 { $1 = NR - 2 } { print }' $from/sizes.xyz > "$tmp/index.xyz" && measure i p "$tmp/index.xyz" &&
    near "$(value nearest "$tmp/i")" "$(awk -v a="$(awk 'NR == 3 { print $NF }' $from/sizes.xyz)" -v n="$(value nearest "$tmp/p")" 'BEGIN { printf "%.9g", n * .967512484 / a }')"
}
tell 'two hundred names' index
tell 'have too many pairs' refused 'o.scene:2: measure.partials counts pairs of species, and 200 species have too many; give at most 20 species' \
  "$randpack" measure "$tmp/index.xyz" --scene "$tmp/o.scene" --out "$tmp/new"

# Radii that the file does not tell; a unit that the scene says.
bare() {
  sed '2s/:radius:R:1//; 3,$s/ [^ ]*$//' $from/spheres.xyz > "$tmp/bare.xyz"
  printf 'species = ( { name = "A"; radius = 1.0; } );\n' | cat "$tmp/m.scene" - > "$tmp/r.scene"
  measure b r "$tmp/bare.xyz" && diff -r "$tmp/m" "$tmp/b"
}
tell 'the scene tells the radius' bare
tell 'or else there is none' refused "no radii; Properties must hold radius:R:1 or diameter:R:1, or the scene must give a radius" \
  "$randpack" measure "$tmp/bare.xyz" --scene "$tmp/m.scene" --out "$tmp/new"
# One radius for all, by the fraction and the number: (3 phi V / 4 pi n)^(1/3) = <a^3>^(1/3).
estimate() {
  sed '2s/:radius:R:1//; 3,$s/ [^ ]*$//' $from/sizes.xyz > "$tmp/bare.xyz"
  mean=$(awk 'NR > 2 { n++; cubes += $NF ^ 3 } END { printf "%.17g", (cubes / n) ^ (1 / 3) }' $from/sizes.xyz)
  awk -v a="$mean" 'NR > 2 { $NF = a } { print }' $from/sizes.xyz > "$tmp/one.xyz"
  printf 'fraction = %.17g;\n' "$(value fraction "$tmp/p")" | cat "$tmp/p.scene" - > "$tmp/f.scene"
  measure f f "$tmp/bare.xyz" && measure g p "$tmp/one.xyz" && near "$(value nearest "$tmp/f")" "$(value nearest "$tmp/g")" &&
    near "$(value reduced_density "$tmp/f")" "$(value fraction "$tmp/p")" &&
    diff <(awk '/^[0-9]/ { printf "%.9g %.9g\n", $1, $2 }' "$tmp/f/rdf.tsv") <(awk '/^[0-9]/ { printf "%.9g %.9g\n", $1, $2 }' "$tmp/g/rdf.tsv") &&
    grep -q "^# unit of length a = $(printf %.8g "$mean")[0-9]*, the radius of grain, estimated from fraction and number$" "$tmp/f/rdf.tsv"
}
tell 'one radius for all, from the fraction' estimate
bias() {
  ends 0 "$randpack" measure "$tmp/bare.xyz" --scene "$tmp/f.scene" --set "fraction=$(awk -v f="$(value fraction "$tmp/p")" 'BEGIN { print f * 1.05 ^ 3 }')" \
    --out "$tmp/h" && near "$(value nearest "$tmp/h")" "$(awk -v r="$(value nearest "$tmp/f")" 'BEGIN { printf "%.17g", r / 1.05 }')"
}
tell 'one larger by five per cent, as B show their bias' bias
tell 'but not without a box' refused 'no box to estimate them from' "$randpack" measure <(sed '2s/Lattice="[^"]*" *//; 2s/pbc="[^"]*"/pbc="F F F"/' "$tmp/bare.xyz") \
  --scene "$tmp/f.scene" --out "$tmp/new"
unit() {
  sed 's/step = 0.5; reach = 4.5/step = 0.25; reach = 2.25/; $s/$/ unit = 2.0;/' "$tmp/m.scene" > "$tmp/u.scene"
  measure u u $from/spheres.xyz && near "$(value nearest "$tmp/u")" 1.079091 &&
    diff <(awk '/^[0-9]/ { print $2 }' "$tmp/m/rdf.tsv") <(awk '/^[0-9]/ { print $2 }' "$tmp/u/rdf.tsv") &&
    grep -q '^# unit of length a = 2, as the scene says$' "$tmp/u/rdf.tsv"
}
tell 'the scene says the unit' unit
# Contact is where the particles touch, in any unit: here the radius is 1, and all lengths are the same.
touching() { # touching UNIT
  awk -v u="$1" 'BEGIN { printf "dimension = 3; unit = %g; measure = { contact = { step = %g; }; K = { step = %g; reach = %g; }; structure = { reach = %g; step = %g; };\n", u, .02 / u, .02 / u, 2.5 / u, 4 * u, .5 * u
    printf "rdf = { step = %g; reach = %g; peaks = [%g, %g]; }; partials = { scale = \"r\"; reach = [%g]; step = %g; }; boolean = { reach = %g; step = %g; }; };\n", .5 / u, 3 / u, 2.2 / u, 2.8 / u, 3 / u, .25 / u, 3 / u, .5 / u }' > "$tmp/c.scene"
  measure "c$1" c $from/spheres.xyz
}
same_contact() { # same_contact QUANTITY: is it the same in units of 1, 2 and 0.5?
  for u in 2 0.5; do near "$(value "$1" "$tmp/c$u")" "$(value "$1" "$tmp/c1")" || return 1; done
}
column() { awk -F'\t' -v name="$2" '/^#/ { next } !n++ { for (i = 1; i <= NF; i++) c = $i == name ? i : c; next } { printf "%.6g\n", $c }' "$1"; }
units() { for u in 1 2 0.5; do touching $u || return 1; done; }
tell 'three units' units
for q in contact contact_first_bin Z contact.A-A contact_first_bin.A-A min_gap; do tell "$q is the same in each" same_contact $q; done
jumps() { near "$(awk -v K="$(value K_jump "$tmp/c2")" 'BEGIN { print -8 * K }')" "$(awk -v K="$(value K_jump "$tmp/c1")" 'BEGIN { print -K }')"; }
tell 'and K_jump is one volume' jumps
hard_curve() { for u in 2 0.5; do diff <(column "$tmp/c1/$1.tsv" "$2") <(column "$tmp/c$u/$1.tsv" "$2") || return 1; done; }
tell 'the structure factor of Percus and Yevick is of their radius' hard_curve structure S_py
tell 'and so is the law of hard spheres' hard_curve boolean S2_PY
rooms() { [ "$(tail -1 "$tmp/c2/partial.A-A.tsv" | cut -f 5)" = 1.5 ] && [ "$(tail -1 "$tmp/c0.5/partial.A-A.tsv" | cut -f 5)" = 6 ]; }
tell 'a reach of partials is in this unit' rooms
printf 'dimension = 3; unit = 10.0; measure = { contact = {}; };\n' > "$tmp/wide.scene"
printf 'dimension = 3; unit = 0.1; measure = { contact = { step = 31.0; }; };\n' > "$tmp/narrow.scene"
tell 'a unit that is wider than half the box' measure wide wide $from/spheres.xyz
tell 'and a first bin that leaves it' refused 'measure.contact: the first bin, to R = 51 goes beyond half the box' \
  "$randpack" measure $from/spheres.xyz --scene "$tmp/narrow.scene" --out "$tmp/new"
tell 'which is of packs from files' refused 'unit is only for packs from files; leave it out' "$randpack" run examples/first.scene --set unit=2 --out "$tmp/new"

# What we wrote is measured as it was.
cat > "$tmp/s.scene" <<'END'
dimension = 3; number = 300; fraction = 0.13; save = true;
species = ( { name = "grain"; radius = 1.0; share = 0.8; sizes = { law = "lognormal"; spread = 0.4; }; }, { name = "Fine"; radius = 0.5; share = 0.2; } );
make = { method = "rsa"; order = "large first"; };
measure = { rdf = { step = 0.5; reach = 4.0; }; nearest = {}; partials = { reach = [3.0]; }; };
END
again() {
  rm -rf "$tmp/s" && ends 0 "$randpack" run "$tmp/s.scene" --out "$tmp/s" && cp "$tmp/s/pack-0.xyz" "$tmp/w.xyz" && rm "$tmp/s/pack-0.xyz" &&
    sed -i '/^# \(randpack\|scene\)/d; /^\(attempts\|trials\)\t/d' "$tmp/s"/* && measure w s "$tmp/w.xyz" && diff -r "$tmp/s" "$tmp/w"
}
tell 'a pack of many sizes that we wrote is measured to the same tables' again

# What we wrote is opened by others: names, radii, places and the box, if ASE is there.
python=
for p in python3 /usr/bin/python3; do "$p" -c 'import ase' 2> "$tmp/err" && python=$p; done
opened() {
  "$python" - "$tmp/w.xyz" <<'END'
import sys
from ase.io import read
rows = [line.split() for line in open(sys.argv[1])][2:]
atoms = read(sys.argv[1], format='extxyz')
assert len(atoms) == len(rows) and all(atoms.pbc)
assert list(atoms.arrays['type']) == [row[0] for row in rows] and {'grain', 'Fine'} == set(atoms.arrays['type'])
assert all(a == float(row[4]) for a, row in zip(atoms.arrays['radius'], rows))
assert all(x == float(word) for place, row in zip(atoms.positions, rows) for x, word in zip(place, row[1:4]))
END
}
if [ -n "$python" ]; then
  tell 'ASE opens a pack that we wrote' opened
else
  echo 'SKIP: no ASE (python3-ase), so it opened no pack of ours'
fi
old() {
  sed '2s/Properties=type:/Properties=species:/' "$tmp/w.xyz" > "$tmp/old.xyz" && measure old s "$tmp/old.xyz" && diff -r "$tmp/w" "$tmp/old"
}
tell 'and a pack that was written with species is what it was' old
exit $failed
