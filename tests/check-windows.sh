#!/bin/bash
# tests/check-windows.sh: packs seen through windows. A sample in its box is what a pack that repeats is when its box is taken for a
# window; a window beside a core; what does not fit or is not there is refused in one line.
. tests/tell.sh
from=tests/foreign
scene() { # scene NAME WINDOW EDGES: of spheres.xyz and its like
  cat > "$tmp/$1.scene" <<END
dimension = 3;
$2
measure = { rdf = { step = 0.25; reach = 3.5; $3 }; K = { step = 0.5; reach = 3.5; $3 };
            partials = { reach = [3.5]; step = 0.25; $3 }; };
END
}
measure() { # measure OUT SCENE PACK
  rm -rf "${tmp:?}/$1"
  ends 0 "$randpack" measure "$3" --scene "$tmp/$2.scene" --out "$tmp/$1" && sed -i '/^# \(randpack\|scene\)/d' "$tmp/$1"/*
}
near() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a - b < 1e-9 * b && b - a < 1e-9 * b) }' || { echo "$1, not $2"; return 1; }; }
# The same numbers, of all curves, up to rounding: places have moved.
alike() {
  local file
  for file in "$1"/*.tsv; do
    [[ $file = */summary.tsv ]] || paste <(grep -v '^#' "$file") <(grep -v '^#' "$2/${file##*/}") | awk -F'\t' 'NR > 1 { for (i = 1; i <= NF / 2; i++)
      if ($i - $(i + NF / 2) > 1e-9 * ($i + 1) || $(i + NF / 2) - $i > 1e-9 * ($i + 1)) bad = 1 } END { exit bad }' || { echo "$file"; return 1; }
  done
}
sed '2s/$/ pbc="F F F"/; 2s/pbc="T T T"//' $from/spheres.xyz > "$tmp/sample.xyz"
both() {
  local edges
  for edges in minus ripley translation; do
    scene torus '' "edges = \"$edges\";" && scene sample 'window = {};' "edges = \"$edges\";" || return 1
    measure torus torus $from/spheres.xyz && measure sample sample "$tmp/sample.xyz" && alike "$tmp/torus" "$tmp/sample" || return 1
  done
}
tell 'the box of a sample, and that of a torus taken for a window' both

# A ball as large as the core is the default of a finite pack with weights.
core() {
  local radius
  radius=$(awk 'NR == 2 { match($0, /Lattice="[0-9.]*/); print 0.6 * substr($0, RSTART + 9, RLENGTH - 9) / 2 }' "$tmp/sample.xyz")
  scene core '' 'edges = "ripley";' && scene ball "window = { shape = \"ball\"; radius = $radius; };" 'edges = "ripley";' &&
    sed -i 's/3\.5/2.75/g' "$tmp/core.scene" "$tmp/ball.scene" &&
    measure core core "$tmp/sample.xyz" && measure ball ball "$tmp/sample.xyz" && alike "$tmp/core" "$tmp/ball"
}
tell 'a ball as large as the core' core

# Of one species, the pairs of species are all pairs; the neighbours of a bead are K times the others by the volume.
one() {
  scene one "window = { shape = \"ball\"; radius = 4.9; };" 'edges = "ripley";' && measure one one "$tmp/sample.xyz" || return 1
  paste <(awk -F'\t' '$1 + 0 > 2' "$tmp/one/rdf.tsv") <(grep '^[0-9]' "$tmp/one/partial.A-A.tsv") | awk -F'\t' '
    ($2 - $6) ^ 2 > 1e-18 * $2 ^ 2 { bad = 1 } END { exit bad || NR != 6 }' || { echo 'g'; return 1; }
  near "$(awk '$1 == 3.5 { print $2 }' "$tmp/one/K.tsv")" "$(awk -F'\t' '$5 == 3.5 { print $6 }' "$tmp/one/partial.A-A.tsv")" &&
    near "$(awk -F'\t' -v n="$(value centres "$tmp/one")" '$5 == 3.5 { printf "%.12g", $6 * (n - 1) / (4 / 3 * atan2(0, -1) * 4.9 ^ 3) }' "$tmp/one/partial.A-A.tsv")" \
      "$(awk -F'\t' '$5 == 3.5 { print $8 }' "$tmp/one/partial.A-A.tsv")"
}
tell 'pairs of a single species are all pairs' one

# The window's fraction is that of the centres in it.
fraction() {
  scene box 'window = { side = 6.0; };' 'edges = "translation";' && measure box box "$tmp/sample.xyz" || return 1
  near "$(value fraction "$tmp/box")" "$(awk 'NR == 2 { match($0, /Lattice="[0-9.]*/); L = substr($0, RSTART + 9, RLENGTH - 9) }
    NR > 2 { if (($2 - L / 2) ^ 2 <= 9 && ($3 - L / 2) ^ 2 <= 9 && ($4 - L / 2) ^ 2 <= 9) { sum += $5 ^ 3; n++ } }
    END { printf "%.12g", sum * 4 / 3 * atan2(0, -1) / 216 }' "$tmp/sample.xyz")"
}
tell 'the fraction by the centres in a window' fraction

# A slab, whichever way it lies, and as a dump; a sample of the same place, which does not repeat, has fewer pairs.
turn() { awk -v pbc="$2" 'NR == 2 { sub(/pbc="[^"]*"/, "pbc=\"" pbc "\"") } NR > 2 { x = $2; $2 = $4; $4 = x } { print }' "$1"; }
slab() {
  local edges
  sed '2s/pbc="T T T"/pbc="F T T"/' $from/spheres.xyz > "$tmp/slab.xyz" && turn "$tmp/slab.xyz" 'T T F' > "$tmp/turned.xyz" || return 1
  { printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n60\nITEM: BOX BOUNDS ff pp pp\n0 10\n-3 7\n0 10\nITEM: ATOMS type x y z radius\n'
    awk -v OFMT=%.12g 'NR > 2 { print 1, $2, $3 - 3, $4, $5 }' "$tmp/slab.xyz"; } > "$tmp/slab.dump"
  for edges in minus ripley translation; do
    scene slab '' "edges = \"$edges\";" && measure slab slab "$tmp/slab.xyz" && measure turned slab "$tmp/turned.xyz" && alike "$tmp/slab" "$tmp/turned" &&
      scene dump '' "edges = \"$edges\";" && measure dump dump "$tmp/slab.dump" || return 1
    diff <(grep '^[0-9]' "$tmp/slab/K.tsv" | cut -f1 ) <(grep '^[0-9]' "$tmp/dump/K.tsv" | cut -f1) &&
      near "$(tail -1 "$tmp/slab/K.tsv" | cut -f2)" "$(tail -1 "$tmp/dump/K.tsv" | cut -f2)" || return 1
  done
  scene sample 'window = {};' 'edges = "translation";' && measure sample sample "$tmp/sample.xyz" &&
    [ "$(value pairs "$tmp/sample")" -lt "$(value pairs "$tmp/slab")" ] && near "$(value fraction "$tmp/slab")" 0.251327412287
}
tell 'a slab, turned, and as a dump' slab
printf 'dimension = 3;\nmeasure = { structure = {}; };\n' > "$tmp/structure.scene"
tell 'a slab has no structure factor' refused 'structure allows no packs with walls; leave it out' \
  "$randpack" measure "$tmp/slab.xyz" --scene "$tmp/structure.scene" --out "$tmp/new"
printf 'dimension = 3;\nmeasure = { K = { edges = "toroidal"; }; };\n' > "$tmp/torus.scene"
tell 'nor is it a torus' refused 'edges of measure.K are toroidal, but a pack with walls is not periodic; give "minus"' \
  "$randpack" measure "$tmp/slab.xyz" --scene "$tmp/torus.scene" --out "$tmp/new"
sed '2s/pbc/Origin="-5 0 0" pbc/' "$tmp/slab.xyz" > "$tmp/moved.xyz"
scene moved '' ''
tell 'a slab whose box is elsewhere' refused 'of 60 centres lie outside the box of the file; give its Origin' \
  "$randpack" measure "$tmp/moved.xyz" --scene "$tmp/moved.scene" --out "$tmp/new"
printf '2\nLattice="8 0 0 0 8 0 0 0 8" Properties=species:S:1:pos:R:3:radius:R:1 pbc="T T F"\nA 1 2 3 1\nA 5 6 %s 1\n' 7 > "$tmp/planes.xyz"
sed 's/ 7 1$/ 3 1/' "$tmp/planes.xyz" > "$tmp/discs.xyz"
tell 'discs in space' refused 'has dimension 2; the scene says 3' "$randpack" measure "$tmp/discs.xyz" --scene "$tmp/moved.scene" --out "$tmp/new"
sed -i 's/dimension = 3/dimension = 2/' "$tmp/moved.scene"
tell 'discs in two planes' refused 'z is not constant, as it must be for discs; to read a slab in space give dimension = 3 in the scene' \
  "$randpack" measure "$tmp/planes.xyz" --scene "$tmp/moved.scene" --out "$tmp/new"

scene large 'window = { side = 60.0; };' ''
tell 'a window that is too large' refused 'the window does not lie within the pack; give a smaller one' \
  "$randpack" measure "$tmp/sample.xyz" --scene "$tmp/large.scene" --out "$tmp/new"
scene far 'window = { side = 6.0; };' 'edges = "minus";'
tell 'a window in which no centre is deep enough' refused 'measure.rdf needs a centre in the window, R = 3.5 or more from its edge, and there is none, the deepest is at R = ' \
  "$randpack" measure "$tmp/sample.xyz" --scene "$tmp/far.scene" --out "$tmp/new"
scene cut 'window = { shape = "ball"; radius = 3.0; };' 'edges = "ripley";'
tell 'a window in which a sphere is nowhere inside' refused 'the window allows R up to ' \
  "$randpack" measure "$tmp/sample.xyz" --scene "$tmp/cut.scene" --out "$tmp/new"
# Pairs of species: too far in a periodic pack is refused before anything is counted. A single particle in the window has no pairs, so
# its bins end with the window.
scene pairs 'window = { shape = "ball"; radius = 2.0; };' ''
tell 'pairs of species beyond the window of a file' refused 'measure.rdf.reach = 3.5 goes beyond what its edges allow' \
  "$randpack" measure $from/spheres.xyz --scene "$tmp/pairs.scene" --out "$tmp/new"
sed -i '/measure = /,$d' "$tmp/pairs.scene" && echo 'measure = { partials = { reach = [3.5]; step = 0.25; scale = "r"; }; };' >> "$tmp/pairs.scene"
tell 'without other measures too' refused 'measure.partials: A-A touch at R = 2, and what the window allows ends at 2' \
  "$randpack" measure $from/spheres.xyz --scene "$tmp/pairs.scene" --out "$tmp/new"
lone() {
  printf '2\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3:radius:R:1 pbc="F F F"\nA 4.5 4.5 4.5 1\nA 1 1 1 1\n' > "$tmp/lone.xyz"
  sed -i 's/radius = 2.0/radius = 2.6/' "$tmp/pairs.scene"
  measure lone pairs "$tmp/lone.xyz" && [ "$(value number.A "$tmp/lone")" = 1 ] && [ "$(grep -c '^[0-9]' "$tmp/lone/partial.A-A.tsv")" = 2 ]
}
tell 'a window with a single particle' lone
exit "$failed"
