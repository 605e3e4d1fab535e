#!/bin/bash
# tests/check-packs.sh: packs from elsewhere. The wrong ones are refused with file, line and reason; those
# that only look unusual give the numbers of the plain one.
. tests/tell.sh
cat > "$tmp/s.scene" <<'END'
dimension = 3;
measure   = { rdf = { reach = 4.0; step = 0.25; }; nearest = {}; coordination = {}; };
END
box='Lattice="8 0 0 0 8 0 0 0 8"' what='Properties=species:S:1:pos:R:3:radius:R:1' pbc='pbc="T T T"'
full="$box $what $pbc"

# bad NAME LINE WORDS TEXT: the pack TEXT is refused at this line.
bad() {
  local name=$1 place=$2 words=$3
  printf '%b' "$4" > "$tmp/p.xyz"
  tell "$name" refused "$tmp/p.xyz:$place: $words" "$randpack" measure "$tmp/p.xyz" \
    --scene "$tmp/s.scene" --out "$tmp/new"
}
# hostile NAME PLACE WORDS: the file, of few or many bytes, is refused with no more memory than its lines are long.
hostile() {
  tell "$1" refused "$tmp/h:$2: $3" bash -c 'ulimit -v 700000; exec "$@"' - "$randpack" measure "$tmp/h" --scene "$tmp/s.scene" --out "$tmp/new"
}
two='A 1 2 3 1\nA 5 6 7 1\n'
printf '1000000000000000000\n%s\nA 1 2 3 1\n' "$full" > "$tmp/h"
hostile 'a number that is a lie' 4 'the file ends here; each particle'
printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1e15\nITEM: BOX BOUNDS pp pp pp\n0 8\n0 8\n0 8\nITEM: ATOMS x y z radius\n1 1 1 1\n' > "$tmp/h"
hostile 'in a dump' 11 'the file ends here; each particle'
printf 'LAMMPS\n1e15 atoms\n0 8 xlo xhi\n0 8 ylo yhi\n0 8 zlo zhi\nAtoms # sphere\n\n1 1 1 1 1 1 1\n' > "$tmp/h"
hostile 'in a data file' 9 'the file ends here; each particle'
{ printf '1\n%s\nA 1 2 3 1 ' "$full"; head -c 4000000 /dev/zero | tr '\0' a; echo; } > "$tmp/h"
hostile 'a line of megabytes' 3 '6 words, but Properties names 5 columns; give one'
{ printf '1\n%s a=' "$full"; head -c 1000000 /dev/zero | tr '\0' '['; printf '\nA 1 2 3 1\n'; } > "$tmp/h"
hostile 'a million brackets' 2 'a bracket without its partner; see'
{ printf '1000000\n%s\n' "$full"; seq 1000000 | awk '{ print "S" $1, 1, 2, 3, 1 }'; } > "$tmp/h"
hostile 'a million names' 65537 'too many species; give at most 65534'
head -c 40000000 /dev/zero | gzip > "$tmp/h"
hostile 'nothing but zeros, in forty kilobytes' 1 'a byte of zero; give a text'
cp "$randpack" "$tmp/h"
hostile 'a program' 1 'a byte of zero; give a text'
{ printf 'dimension = 3; make = '; for _ in {1..20000}; do printf '{a='; done; } > "$tmp/deep.scene"
tell 'a scene that is deep' refused 'deep.scene:1: too many brackets within brackets; settings' "$randpack" plan "$tmp/deep.scene"
bad 'an empty file' 1 'the file ends here; the first' ''
bad 'a word for the number' 1 'not a pack; give' "two\n$full\n$two"
bad 'a negative number' 1 'no number of particles; the first line' "-2\n$full\n$two"
bad 'half a particle' 1 'no number of particles; the first line' "2.5\n$full\n$two"
bad 'a number alone' 2 'the file ends here; each' '2\n'
bad 'a file cut short' 5 'the file ends here; each' "3\n$full\n$two"
bad 'more particles than memory' 5 'the file ends here; each' "18446744073709551615\n$full\n$two"
bad 'a line cut short' 4 '3 words, but Properties names 5 columns; give one' "2\n$full\nA 1 2 3 1\nA 5 6\n"
bad 'a second pack behind the first' 5 'more lines than particles, and no second pack; the first' "2\n$full\n$two$two"
bad 'no box' 2 'no box, and the pack is periodic; give Lattice' "2\n$what $pbc\n$two"
bad 'a box of eight numbers' 2 'Lattice is not nine numbers; give Lattice' "2\nLattice=\"8 0 0 0 8 0 0 0\" $what $pbc\n$two"
bad 'a tilted box' 2 'the box is oblique, with 82.87 degrees between its first two vectors; only' "2\nLattice=\"8 0 0 1 8 0 0 0 8\" $what\n$two"
bad 'a flat box' 2 'a side of the box is not above 0; give' "2\nLattice=\"8 0 0 0 0 0 0 0 8\" $what\n$two"
bad 'an endless box' 2 'a side of the box is not from 1e-50 to 1e50; choose' "2\nLattice=\"inf 0 0 0 8 0 0 0 8\" $what\n$two"
bad 'no columns told' 2 'no radii; Properties' "2\n$box $pbc\n$two"
bad 'no positions' 2 'no positions; Properties' "2\n$box Properties=species:S:1:radius:R:1\nA 1\nA 1\n"
bad 'no radii' 2 'no radii; Properties' "2\n$box Properties=species:S:1:pos:R:3\nA 1 2 3\nA 5 6 7\n"
bad 'a property of -1 columns' 2 'a property without a number of columns; give' "2\n$box $what:x:R:-1\n$two"
bad 'a word for a position' 4 '6,5 in column 3 is not a number; a decimal point, not a comma' "2\n$full\nA 1 2 3 1\nA 5 6,5 7 1\n"
bad 'a position that is no number' 4 'a position is not finite; give' "2\n$full\nA 1 2 3 1\nA 5 nan 7 1\n"
bad 'a radius of 0' 4 'a radius is not above 0; give' "2\n$full\nA 1 2 3 1\nA 5 6 7 0\n"
bad 'a negative radius' 3 'a radius is not above 0; give' "2\n$full\nA 1 2 3 -1\nA 5 6 7 1\n"

refuse() {
  tell "$1" refused "$2" "$randpack" measure "$tmp/p.xyz" --scene "${3:-$tmp/s.scene}" --out "$tmp/new"
}
printf '%b' "0\n$full\n" > "$tmp/p.xyz"
refuse 'a pack of no particles' "$tmp/p.xyz: no particles; there must be one"
printf '%b' "2\n$box $what pbc=\"T T F\"\nA 1 2 3 1\nA 5 6 3 1\n" > "$tmp/p.xyz"
refuse 'a pack of another dimension' "$tmp/p.xyz: has dimension 2; the scene says 3"
printf '%b' "2\nLattice=\"8 0 0 0 7 0 0 0 9\" $what\n$two" > "$tmp/p.xyz"
refuse 'a reach beyond half of its box' "measure.rdf.reach = 4 goes beyond half the box; the largest reach here is 3.5"
printf '%b' "2\n$full\nA 1 2 3 1\nB 5 6 7 0.5\n" > "$tmp/p.xyz"
printf 'dimension = 3; measure = { contact = {}; };' > "$tmp/c.scene"
refuse 'a contact value of two sizes' "has several sizes; contact needs particles of one size" "$tmp/c.scene"
plain() { # plain NAME WORDS SCENE TEXT: a table of numbers is refused
  printf '%b' "$4" > "$tmp/p.csv"
  printf '%b' "$3" > "$tmp/p.scene"
  tell "$1" refused "$2" "$randpack" measure "$tmp/p.csv" --scene "$tmp/p.scene" --out "$tmp/new"
}
one='dimension = 3;\nside = 10.0;\nmeasure = {\n'
row='3,5,5,1\n7,5,5.5,1\n'
plain 'an empty cell' "$tmp/p.csv:3: an empty cell is not a number; see" "${one}nearest = {}; };" 'x,y,z,r\n1,2,3,1\n1,,6,1\n'
for measure in 'profile = {}|profile and radial need finite packs; give' 'radial = {}|profile and radial need finite packs; give' \
  'approach = {}|approach needs random sequential addition; give'; do
  plain "a measure that needs a maker: ${measure%% *}" "$tmp/p.scene:4: ${measure#*|}" "$one${measure%|*}; };" "$row"
done
plain 'an overlap in a flight' "$tmp/p.csv: the pack overlaps by 1e-07 of the largest radius, and a flight allows 2e-12; give" \
  "${one}pressure = {}; };" '1,1,1,1\n2.9999999,1,1,1\n'
finite='dimension = 3; measure ='
plain 'no centre in the core' "$tmp/p.csv: no centre is in the core; give more particles" "$finite { nearest = {}; };" '-9,0,0,1\n9,0,0,1\n'
plain 'no centre that is deep enough' "$tmp/p.csv: measure.nearest needs a centre in the core, R = 3 or more from its edge, and there is none, the deepest is at R = 2; give more" \
  "$finite { nearest = { reach = 3.0; }; };" '-9,0,0,1\n9,0,0,1\n0,0,4,1\n0,-9,0,1\n0,9,0,1\n0,0,9,1\n0,0,-9,1\n'
plain 'nor in the window' "$tmp/p.csv: measure.nearest needs a centre in the window, R = 3 or more from its edge, and there is none, the deepest is at R = 2; give more" \
  "dimension = 3; side = 20.0; window = { side = 10.0; }; measure = { nearest = { reach = 3.0; }; };" '7,10,10,1\n12,13,10,1\n12,7,10,1\n'
tell 'nothing was written' test ! -e "$tmp/new"

# good NAME TEXT: the pack gives the numbers of the first one.
measure() {
  printf '%b' "$1" > "$tmp/p.xyz"
  rm -rf "$tmp/got"
  ends 0 "$randpack" measure "$tmp/p.xyz" --scene "$tmp/s.scene" --out "$tmp/got"
}
same() { measure "$1" && diff -r "$tmp/plain" "$tmp/got"; }
good() { tell "$1" same "$2"; }
three='A 1.25 2 3 1\nA 5 6 7.5 1\nA 1 6.5 0 1\n'
measure "3\n$full\n$three" && mv "$tmp/got" "$tmp/plain"
tell 'a plain pack is measured' test "$(value number "$tmp/plain")" = 3
radii() { # of two species, from the scene, which needs no amounts: as from the file
  printf 'species,x,y,z\nA,1,1,1\nB,6,6,6\nA,4,8,2\n' > "$tmp/r.csv"
  printf 'species,x,y,z,r\nA,1,1,1,1\nB,6,6,6,2\nA,4,8,2,1\n' > "$tmp/R.csv"
  echo 'dimension = 3; side = 10.0; measure = { nearest = {}; };' > "$tmp/R.scene"
  echo 'dimension = 3; side = 10.0; measure = { nearest = {}; }; species = ( { name = "A"; radius = 1.0; }, { name = "B"; radius = 2.0; } );' > "$tmp/r.scene"
  for f in r R; do ends 0 "$randpack" measure "$tmp/$f.csv" --scene "$tmp/$f.scene" --out "$tmp/of-$f" || return 1; done
  diff -I '^# scene' -r "$tmp/of-r" "$tmp/of-R"
}
tell 'radii of two species from the scene' radii
good 'positions beyond the box are wrapped' "3\n$full\nA 9.25 -6 3 1\nA -11 14 7.5 1\nA 1 6.5 8 1\n"
good 'Windows line ends' "3\r\n$full\r\nA 1.25 2 3 1\r\nA 5 6 7.5 1\r\nA 1 6.5 0 1\r\n"
good 'blank lines at the end' "3\n$full\n$three\n\n"
good 'no line end at the end' "3 \n$full\nA 1.25 2 3 1\nA 5 6 7.5 1\nA 1 6.5 0 1"
good 'further columns in another order' "3\n$box Properties=id:I:1:radius:R:1:v:R:2:pos:R:3:species:S:1 $pbc\n\
1 1 x y 1.25 2 3 A\n2 1 0 0 5 6 7.5 A\n3 1.0 0 0 1e0 6.5 0 A\n"
good 'no species' "3\n$box Properties=pos:R:3:radius:R:1\n1.25 2 3 1\n5 6 7.5 1\n1 6.5 0 1\n"
good 'tabs between words' "3\n$full\nA\t1.25\t2\t3\t1\nA\t5\t6\t7.5\t1\nA\t1\t6.5\t0\t1\n"
good 'a box that an earlier comment names' "3\ncomment=\"was Lattice=3\" $full\n$three"
good 'a note before the box' "3\nTime=3 MyLattice=\"1\" $full\n$three"

# Names of species that stand in names of tables. Where they do not, they are as good as others.
cat > "$tmp/pairs.scene" <<'END'
dimension = 3; unit = 1.0; measure = { partials = { reach = [3.0]; step = 0.5; }; };
END
names() { printf '4\n%s\n%s 1 1 1 1\n%s 5 5 5 1\n%s 1 5 1 1\n%s 5 1 5 1\n' "$full" "$@" > "$tmp/p.xyz"; }
names A ../B C D
tell 'a species with a slash' refused 'p.xyz: the species ../B has a slash in its name, and measure.partials writes tables with that name; give' \
  "$randpack" measure "$tmp/p.xyz" --scene "$tmp/pairs.scene" --out "$tmp/new"
tell 'where no table is named after it' ends 0 "$randpack" measure "$tmp/p.xyz" --scene "$tmp/s.scene" --out "$tmp/slash"
names A A-B B-C C
tell 'two pairs of species of one name' refused 'p.xyz: two pairs of species would be called A-B-C: A with B-C, and A-B with C; give' \
  "$randpack" measure "$tmp/p.xyz" --scene "$tmp/pairs.scene" --out "$tmp/new"
tell 'without tables of pairs' ends 0 "$randpack" measure "$tmp/p.xyz" --scene "$tmp/s.scene" --out "$tmp/alike"
names A A-B B-C D
dashes() { ends 0 "$randpack" measure "$tmp/p.xyz" --scene "$tmp/pairs.scene" --out "$tmp/dashes" && [ "$(ls "$tmp/dashes"/partial.* | wc -l)" = 10 ]; }
tell 'names with dashes' dashes
tell 'and nothing is written' test ! -e "$tmp/new"
exit $failed
