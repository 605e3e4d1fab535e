#!/bin/bash
# tests/check-convert.sh: packs in other formats, read back by awk and od and by this program itself. tests/slow-convert.sh has the
# programs that they are for.
. tests/packs.sh
convert() { ends 0 "$randpack" convert "$@" && [ ! -s "$tmp/out" ] && [ ! -s "$tmp/err" ]; }
two='species = ( { name = "1"; radius = 1.0; number = 60; }, { name = "2"; radius = 0.6; number = 90; } );'
tell 'spheres of two sizes' make deep "dimension = 3; seed = 3; fraction = 0.3; $two make = { method = \"rsa\"; }; save = true;"
tell 'discs' make flat "dimension = 2; seed = 4; box = [1.0, 1.5]; fraction = 0.4; $two make = { method = \"rsa\"; }; save = true;"
tell 'spheres with radii of their own' make own 'dimension = 3; seed = 5; number = 150; fraction = 0.25; save = true;
  species = ( { name = "1"; radius = 1.0; share = 1.0; sizes = { law = "lognormal"; spread = 0.3; }; } ); make = { method = "rsa"; order = "large first"; };'
tell 'a finite pack' make heap 'dimension = 3; seed = 6; species = ( { name = "1"; radius = 1.0; number = 150; } ); make = { method = "gravity"; }; save = true;'
sides() { sed -n '2s/.*Lattice="\([^"]*\)".*/\1/p' "$1" | awk '{ print $1, $5, $9 }'; }
side() { sides "$1" | cut -d' ' -f1; }

# --- names of formats
tell 'an ending that is none names them all' refused 'no format has this ending; give .xyz, .csv, .txt .dat .xyzr, .data, .vtu, .vti, .nrrd, .raw, .geo, .pov, or --format' \
  "$randpack" convert "$tmp/deep.xyz" "$tmp/x.stl"
tell 'a name without an ending too' refused 'no format has this ending' "$randpack" convert "$tmp/deep.xyz" "$tmp/x"
tell 'and a format that is none' refused '--format stl: no such format; give one of xyz, csv, xyzr, lammps, vtu, vti, nrrd, raw, gmsh, pov' \
  "$randpack" convert "$tmp/deep.xyz" "$tmp/x" --format stl
helps() { ends 0 "$randpack" help convert && for f in xyz csv xyzr lammps vtu vti nrrd raw gmsh pov; do grep -q "^  $f " "$tmp/out" || return 1; done; }
tell 'help convert lists the formats' helps
named() { convert "$tmp/deep.xyz" "$tmp/named" --format CSV && convert "$tmp/deep.xyz" "$tmp/named.CSV" && cmp "$tmp/named" "$tmp/named.CSV"; }
tell 'a format by its name, an ending in capitals' named
tell 'shapes in a list' refused 'shapes.xyz: has shapes, and csv cannot hold that; xyz, lammps, vtu, vti, nrrd, raw, gmsh, pov can' \
  "$randpack" convert "$tmp/shapes.xyz" "$tmp/x.csv"
tell 'a pentagon for LAMMPS' refused 'shapes.xyz: the species P has a shape that is no ellipse, and LAMMPS has ellipsoids only; xyz' \
  "$randpack" convert "$tmp/shapes.xyz" "$tmp/x.data"
tell 'a mesh without a box' refused 'heap.xyz: does not repeat in a box, and gmsh cannot hold that; xyz' "$randpack" convert "$tmp/heap.xyz" "$tmp/x.geo"
tell 'voxels of a list' refused '--cells is not an option of csv; it is an option of vti, nrrd, raw' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.csv" --cells 10
tell 'a gap of voxels' refused '--gap is not an option of vti; it is an option of gmsh' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --gap 0.1
tell 'cells that are none' refused '--cells 8x8: give a whole number from 1 to 32768, or one for each side, as 64x64x32' \
  "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --cells 8x8
tell 'cells with an end missing' refused '--cells 64x: give a whole number' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --cells 64x
tell 'more cells than can be' refused '--cells 40000: give' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --cells 40000
tell 'a step that is none' refused '--step 0: give a length above 0' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --step 0
tell 'two ways to say it' refused '--cells and --step; give one' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --step 1 --cells 9
tell 'one name' refused 'convert needs PACK OUT' "$randpack" convert "$tmp/deep.xyz"
tell 'an option of convert elsewhere' refused '--cells is not an option of plan' "$randpack" plan examples/first.scene --cells 9
tell 'a pack that is none' refused 'none.xyz: cannot be read' "$randpack" convert "$tmp/none.xyz" "$tmp/x.csv"
tell 'nothing was written' test ! -e "$tmp/x.csv" -a ! -e "$tmp/x.vti" -a ! -e "$tmp/x.geo" -a ! -e "$tmp/x.data"

# --- several packs in a file
frames() {
  cat "$tmp/deep.xyz" "$tmp/own.xyz" > "$tmp/both.xyz"
  convert "$tmp/both.xyz" "$tmp/f0.csv" --frame 0 && convert "$tmp/both.xyz" "$tmp/f1.csv" --frame 1 &&
    convert "$tmp/deep.xyz" "$tmp/a.csv" && convert "$tmp/own.xyz" "$tmp/b.csv" && cmp "$tmp/a.csv" "$tmp/f0.csv" && cmp "$tmp/b.csv" "$tmp/f1.csv"
}
tell 'frames are counted from 0' frames
tell 'two packs and no frame' refused 'both.xyz: holds several packs; give --frame 0' "$randpack" convert "$tmp/both.xyz" "$tmp/x.csv"
tell 'a frame too far' refused 'both.xyz: has 2 packs only; give --frame 0 to 1' "$randpack" convert "$tmp/both.xyz" "$tmp/x.csv" --frame 2
tell 'a frame beyond one pack' refused 'deep.xyz: has one pack only; give --frame 0' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.csv" --frame 1
tell 'a frame that is none' refused '--frame -1: give a whole number from 0' "$randpack" convert "$tmp/both.xyz" "$tmp/x.csv" --frame -1

# --- whole or not at all
replaced() { echo old > "$tmp/old.csv" && convert "$tmp/deep.xyz" "$tmp/old.csv" && cmp "$tmp/old.csv" "$tmp/a.csv"; }
tell 'an old file is replaced' replaced
onto() {
  cp "$tmp/deep.xyz" "$tmp/self.xyz" && ln -s self.xyz "$tmp/other.xyz" || return 1
  for to in self other; do refused "$to.xyz: is the file of the pack itself" "$randpack" convert "$tmp/self.xyz" "$tmp/$to.xyz" || return 1; done
  cmp "$tmp/deep.xyz" "$tmp/self.xyz" && [ -L "$tmp/other.xyz" ]
}
tell 'a pack is not converted onto itself, by any name' onto
full() {
  local f
  for f in csv vti geo; do
    mkdir -p "$tmp/full" && echo old > "$tmp/full/x.$f" && ln -sf /dev/full "$tmp/full/x.$f.part"
    ends 1 "$randpack" convert "$tmp/deep.xyz" "$tmp/full/x.$f" && [ "$(cat "$tmp/full/x.$f")" = old ] && [ ! -e "$tmp/full/x.$f.part" ] || return 1
  done
}
tell 'a full disk keeps the old file whole' full
room() { ends 1 "$randpack" convert "$tmp/deep.xyz" "$tmp/x.vti" --cells 32768 && grep -q 'x.vti: 3.52e+13 voxels take 3.52e+13 bytes, and the disk has .*; give fewer --cells' "$tmp/err" && [ ! -e "$tmp/x.vti" ]; }
if [ "$(df -P -k "$tmp" | awk 'NR == 2 { print $4 }')" -lt 30000000000 ]; then
  tell 'more voxels than the disk has room for' room
fi

# --- lists, out and in again
cat > "$tmp/m3.scene" <<'END'
dimension = 3; unit = 1.0; measure = { rdf = { step = 0.5; reach = 4.0; }; nearest = {}; K = { step = 1.0; reach = 4.0; }; };
END
sed 's/dimension = 3/dimension = 2/' "$tmp/m3.scene" > "$tmp/m2.scene"
measured() { # measured OUT SCENE PACK: the tables without their headers, and without min_gap, whose diameter is the nominal one of a species
  rm -rf "${tmp:?}/$1" && ends 0 "$randpack" measure "$3" --scene "$tmp/$2.scene" --out "$tmp/$1" && sed -i '/^#/d; /^min_gap\t/d' "$tmp/$1"/*
}
with_box() { # with_box SCENE PACK.xyz: the scene and the box of the pack
  { cat "$tmp/$1.scene"; sides "$2" | awk -v d="${1#m}" '{ printf "side = %.17e; box = [%.17e, %.17e", $1, 1, $2 / $1; if (d == 3) printf ", %.17e", $3 / $1; print "];" }'; } > "$tmp/boxed.scene"
}
same() { # same A B TOLERANCE: the same tables, to so much
  [ "$(ls "$tmp/$1")" = "$(ls "$tmp/$2")" ] || return 1
  for t in "$tmp/$1"/*; do
    paste "$t" "$tmp/$2/${t##*/}" | awk -F'\t' -v most="$3" '{ h = NF / 2; for (k = 1; k <= h; k++) if ($k != $(k + h)) { d = $k - $(k + h); s = $k + $(k + h); if (d < 0) d = -d; if (s < 0) s = -s
      if (!(d <= most * (s / 2 + 1e-3))) { print FILENAME ": " $k " " $(k + h); exit 1 } } }' || { echo "${t##*/}"; return 1; }
  done
}
back() { # back NAME DIMENSION TOLERANCE ENDING...: written and measured again
  local name=$1 scene=m$2 most=$3 f to
  shift 3
  with_box "$scene" "$tmp/$name.xyz" && measured want "$scene" "$tmp/$name.xyz" || return 1
  for f in "$@"; do
    to=$tmp/$name.$f && [ "$f" != xyz ] || to=$tmp/$name-again.xyz
    convert "$tmp/$name.xyz" "$to" && rm -rf "$tmp/got" && if [ "$f" = data ] || [ "$f" = xyz ]; then measured got "$scene" "$to"; else measured got boxed "$to"; fi &&
      same want got "$most" || { echo "$name.$f"; return 1; }
  done
}
tell 'two sizes: CSV, LAMMPS data and xyz are measured as the pack is' back deep 3 0 csv data xyz
tell 'discs of two sizes too' back flat 2 0 csv data xyz
tell 'and radii of their own' back own 3 0 csv data xyz txt dat xyzr
one_name() { sed '3,$s/^[^ ]*/A/; 2s/randpack_species="[^"]*"//' "$tmp/$1.xyz" > "$tmp/$1-A.xyz"; }
tell 'lists without species, as a pack without' eval 'one_name deep && back deep-A 3 0 txt dat xyzr && one_name flat && back flat-A 2 0 txt'
printf 'dimension = 3; unit = 1.0; inside = 1.0; measure = { rdf = { step = 0.5; reach = 2.5; }; nearest = {}; };\n' > "$tmp/heap.scene"
scened() { # a list with the box of a scene is a pack that repeats
  with_box m3 "$tmp/deep-A.xyz" && convert "$tmp/deep-A.xyz" "$tmp/want.data" && convert "$tmp/deep-A.txt" "$tmp/got.data" --scene "$tmp/boxed.scene" && cmp "$tmp/want.data" "$tmp/got.data" &&
    convert "$tmp/deep-A.txt" "$tmp/set.data" --scene "$tmp/m3.scene" --set "side=$(printf %.17e "$(side "$tmp/deep-A.xyz")")" && cmp "$tmp/want.data" "$tmp/set.data"
}
tell 'the box of a list from a scene' scened
tell 'a setting without a scene' refused '--set is not an option of convert' "$randpack" convert "$tmp/deep.xyz" "$tmp/x.csv" --set side=3
finite() { # without the radius that only xyz keeps
  sed '2s/Lattice="[^"]*"//; 2s/open=[^ ]*//' "$tmp/heap.xyz" > "$tmp/bare.xyz" && measured want heap "$tmp/bare.xyz" || return 1
  for f in csv txt; do convert "$tmp/heap.xyz" "$tmp/heap.$f" && measured got heap "$tmp/heap.$f" && same want got 1e-9 || { echo $f; return 1; }; done
  measured want heap "$tmp/heap.xyz" && convert "$tmp/heap.xyz" "$tmp/again.xyz" && measured got heap "$tmp/again.xyz" && same want got 0
}
tell 'a finite pack, about its middle' finite
moved() { # a comment says by how much, where the format has comments
  local f
  printf '3\nProperties=species:S:1:pos:R:3:radius:R:1\nA 101 105 105 1\nA 105 105 105 1\nB 109 105 107 1\n' > "$tmp/far.xyz"
  for f in txt data vtu vti nrrd pov; do
    convert "$tmp/far.xyz" "$tmp/far.$f" && [ "$(grep -ac 'places from the middle of the pack; add 105 105 106 for those in the file' "$tmp/far.$f")" = 1 ] || { echo $f; return 1; }
  done
  [ "$(tail -1 "$tmp/far.txt")" = '4 0 1 1' ] && convert "$tmp/far.xyz" "$tmp/again.xyz" || return 1
  awk 'NR == 2 { match($0, /moved="[^"]*/); split(substr($0, RSTART + 7, RLENGTH - 7), m, " ") }
    NR > 2 { for (k = 1; k < 4; k++) printf "%.9g ", $(k + 1) + m[k]; print $5 }' "$tmp/again.xyz" | diff - <(tail -n 3 "$tmp/far.xyz" | cut -d' ' -f2-) &&
    convert "$tmp/deep.xyz" "$tmp/deep.txt" && ! grep -q middle "$tmp/deep.txt"
}
tell 'and by how much it was moved' moved
digits() { diff <(awk 'NR > 2 { print $2 "," $3 "," $4 "," $5 "," $1 }' "$tmp/deep.xyz") <(tail -n +2 "$tmp/deep.csv"); }
tell 'CSV has the digits of the pack' digits
head_csv() { [ "$(head -1 "$tmp/deep.csv")" = 'x [length],y [length],z [length],radius [length],species' ] && [ "$(head -1 "$tmp/flat.csv")" = 'x [length],y [length],radius [length],species' ]; }
tell 'and names with units' head_csv
quoted() {
  printf '1\nLattice="9 0 0 0 9 0 0 0 9" Properties=type:S:1:pos:R:3:radius:R:1\nA,"b 1 2 3 1\n' > "$tmp/q.xyz" && convert "$tmp/q.xyz" "$tmp/q.csv" && [ "$(tail -1 "$tmp/q.csv")" = '1,2,3,1,"A,""b"' ]
}
tell 'a name with a comma and a quote' quoted
sphere() { awk '/^Atoms # sphere/ { on = 1; next } on && NF == 7 { n++; s += $3 ^ 3; bad += $1 != n || $4 != 1 } END { exit !(n == 150 && !bad && (s - 60 * 8 - 90 * 1.728) ^ 2 < 1e-12) }' "$tmp/deep.data" &&
  grep -q '^# type 2: 2$' "$tmp/deep.data" && grep -q '^2 atom types$' "$tmp/deep.data" && head -1 "$tmp/deep.data" | grep -q 'dimension 3; boundary p p p$'; }
tell 'LAMMPS data have diameters, densities and types' sphere
axes() { # the areas of the ellipses, and their quaternions
  convert "$tmp/ellipses.xyz" "$tmp/e.data" && awk '/^Atoms # ellipsoid/ { on = 1; next } /^Ellipsoids/ { on = 2; next }
    on == 1 && NF == 7 { bad += $3 != 1; type[$1] = $2; n++ }
    on == 2 && NF == 8 { d = $2 * $3 / 4 - (type[$1] == 2 ? 1 : 0.25); r = $2 / $3 - (type[$1] == 2 ? 2 : 1); q = $5 ^ 2 + $8 ^ 2 - 1
      bad += d ^ 2 + r ^ 2 + q ^ 2 > 1e-24 || $6 != 0 || $7 != 0; m++ } END { exit !(n == 40 && m == 40 && !bad) }' "$tmp/e.data" &&
    diff <(awk 'NR > 2 { printf "%.7f %.7f\n", $10, $9 }' "$tmp/ellipses.xyz") <(awk 'NF == 8 { printf "%.7f %.7f\n", $5, $8 }' "$tmp/e.data")
}
tell 'ellipses have axes and quaternions' axes

slab() { # between walls across y: places from its middle there, and the walls as faces
  printf '2\nLattice="10 0 0 0 6 0 0 0 9" pbc="T F T" Properties=type:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\nA 9.5 3.75 6 1\n' > "$tmp/slab.xyz"
  convert "$tmp/slab.xyz" "$tmp/slab.csv" && [ "$(tail -n 2 "$tmp/slab.csv" | tr '\n' ';')" = '1,-1,3,1,A;9.5,0.75,6,1,A;' ] && convert "$tmp/slab.xyz" "$tmp/slab.data" && grep -q '^-3 3 ylo yhi$' "$tmp/slab.data" &&
    head -1 "$tmp/slab.data" | grep -q 'boundary p f p$' && convert "$tmp/slab.xyz" "$tmp/slab.txt" && head -1 "$tmp/slab.txt" | grep -qx '# sides of the box 10 6 (between walls) 9, in which it repeats' &&
    convert "$tmp/slab.xyz" "$tmp/slab.pov" && [ "$(grep -c sphere "$tmp/slab.pov")" = 3 ]
}
tell 'a pack between walls' slab
tell 'has no voxels' refused 'slab.xyz: repeats in some directions only, and vti cannot hold that; csv, xyzr, lammps, vtu, pov can' \
  "$randpack" convert "$tmp/slab.xyz" "$tmp/x.vti"

# --- VTU
array() { awk -v name="$1" 'index($0, "Name=\"" name "\"") { on = 1; next } /<\/DataArray>/ { on = 0 } on' "$2"; }
points() {
  convert "$tmp/deep.xyz" "$tmp/deep.vtu" && diff <(array Points "$tmp/deep.vtu") <(awk 'NR > 2 { print $2, $3, $4 }' "$tmp/deep.xyz") &&
    diff <(array radius "$tmp/deep.vtu") <(awk 'NR > 2 { print $5 }' "$tmp/deep.xyz") && diff <(array offsets "$tmp/deep.vtu") <(seq 150) &&
    diff <(array connectivity "$tmp/deep.vtu") <(seq 0 149) && [ "$(array types "$tmp/deep.vtu" | sort -u)" = 1 ] && [ "$(array box "$tmp/deep.vtu")" = "0 0 0 $(sides "$tmp/deep.xyz")" ]
}
tell 'VTU has points, radii and the box' points
polygons() { # area of each cell by its corners against pi radius^2
  convert "$tmp/shapes.xyz" "$tmp/shapes.vtu" && paste <(array offsets "$tmp/shapes.vtu") <(array radius "$tmp/shapes.vtu") <(array species "$tmp/shapes.vtu" | tail -n 60) > "$tmp/cells" &&
    array Points "$tmp/shapes.vtu" | awk 'NR == FNR { n++; end[n] = $1; r[n] = $2; kind[n] = $3; next } { x[p + 0] = $1; y[p + 0] = $2; p++ }
      END { for (c = 1; c <= n; c++) { from = end[c - 1] + 0; a = 0; for (k = from; k < end[c]; k++) { m = k + 1 < end[c] ? k + 1 : from; a += (x[k] * y[m] - x[m] * y[k]) / 2 }
        off = 1 - a / (3.14159265358979 * r[c] ^ 2); want = kind[c] == 1 ? 1 - 64 * sin(2 * 3.14159265358979 / 64) / (2 * 3.14159265358979) : kind[c] == 2 ? 0 : off > 0 && off < 0.006 ? off : 1
        bad += (off - want) ^ 2 > 1e-18; seen[kind[c]]++ } exit !(n == 60 && !bad && seen[1] == 20 && seen[2] == 20 && seen[3] == 20) }' "$tmp/cells" -
}
tell 'shapes are polygons of their areas' polygons
names() { [ "$(array species "$tmp/shapes.vtu" | head -3 | tr '\n' ';')" = '68 0;80 0;83 0;' ]; }
tell 'labels are in the order of the names' names

# --- voxels
raw() { # raw SIZE FILE: the last SIZE bytes as counts "label number"
  tail -c "$1" "$2" | od -An -v -tu1 -w1 | sort -n | uniq -c | awk '{ print $2, $1 }'
}
field() { sed -n "s/^$1: //p" "$2" | head -1; }
fraction_of() { # fraction_of LABEL COUNTS N: the fraction of voxels
  awk -v l="$1" -v n="$3" '$1 == l { print $2 / n }' "$2"
}
law() { # law NAME N: voxels of both species within 3.5 standard errors of the law
  local n=$2
  convert "$tmp/$1.xyz" "$tmp/$1.nrrd" --cells "$n" && read -r a b c <<< "$(field sizes "$tmp/$1.nrrd")" && raw $((a * b * ${c:-1})) "$tmp/$1.nrrd" > "$tmp/counts" &&
    [ "$(head -c 8 "$tmp/$1.nrrd")" = NRRD0004 ] && [ "$(field encoding "$tmp/$1.nrrd")" = raw ] && [ "$(field type "$tmp/$1.nrrd")" = uint8 ] &&
    awk -v dim="$(field dimension "$tmp/$1.nrrd")" -v cells=$((a * b * ${c:-1})) -v na="$a" 'NR == FNR { count[$1] = $2; next }
      FNR == 2 { split($0, w, "\""); split(w[2], v, " "); V = v[1] * v[5] * (dim == 3 ? v[9] : 1); h = v[1] / na }
      FNR > 2 { r = $5; pi = 3.14159265358979; solid[$1] += dim == 3 ? 4 * pi * r ^ 3 / 3 : pi * r ^ 2; surface[$1] += dim == 3 ? 4 * pi * r ^ 2 : 2 * pi * r }
      END { for (s in solid) { e = sqrt(dim == 3 ? 0.06665 * surface[s] * h ^ 4 : 0.07284 * surface[s] * h ^ 3) / V; d = count[s] / cells - solid[s] / V
        printf "%s: %.6f, %.2f standard errors off\n", s, count[s] / cells, d / e; if (d ^ 2 > (3.5 * e) ^ 2) bad = 1 } exit bad }' "$tmp/counts" "$tmp/$1.xyz" > "$tmp/told" || { cat "$tmp/told"; return 1; }
}
for n in 20 40 80; do tell "spheres in $n^3 voxels have their fractions" law deep $n; done
for n in 50 200; do tell "discs in $n voxels along a side too" law flat $n; done
header() {
  read -r L rest <<< "$(sides "$tmp/deep.xyz")"
  [ "$(field 'space directions' "$tmp/deep.nrrd" | awk -F'[(,)]' '{ print $2 == $8, NF }')" = "0 13" ] && awk -v L="$L" -v s="$(field 'space directions' "$tmp/deep.nrrd")" -v o="$(field 'space origin' "$tmp/deep.nrrd")" \
    'BEGIN { split(s, a, /[(,)]/); split(o, b, /[(,)]/); exit !((a[2] * 80 - L) ^ 2 < 1e-20 && a[3] == 0 && a[4] == 0 && (b[2] - a[2] / 2) ^ 2 < 1e-24) }' &&
    grep -qx 'label 1:=1' "$tmp/deep.nrrd" && [ "$(field sizes "$tmp/flat.nrrd")" = '133 200' ] && grep -q '^space dimension: 2$' "$tmp/flat.nrrd"
}
tell 'the header of NRRD tells sizes, spacing and labels' header
three() { # three formats, the same bytes
  convert "$tmp/deep.xyz" "$tmp/v.nrrd" --cells 20x24x31 && convert "$tmp/deep.xyz" "$tmp/v.raw" --cells 20x24x31 && convert "$tmp/deep.xyz" "$tmp/v.vti" --cells 20x24x31 || return 1
  [ "$(wc -c < "$tmp/v.raw")" = 14880 ] && tail -c 14880 "$tmp/v.nrrd" | cmp - "$tmp/v.raw" && head -c -$((14880 + 28)) "$tmp/v.vti" | tail -c 9 | od -An -tx1 | grep -q '5f 20 3a 00 00 00 00 00 00' &&
    tail -c $((14880 + 28)) "$tmp/v.vti" | head -c 14880 | cmp - "$tmp/v.raw" && grep -aq 'WholeExtent="0 20 0 24 0 31"' "$tmp/v.vti" &&
    grep -qx 'data file: v.raw' "$tmp/v.nhdr" && [ "$(field sizes "$tmp/v.nhdr")" = '20 24 31' ]
}
tell 'VTI, NRRD and raw have the same voxels' three
threads() { for t in 1 3; do convert "$tmp/deep.xyz" "$tmp/t$t.raw" --cells 40 --threads $t || return 1; done; cmp "$tmp/t1.raw" "$tmp/t3.raw"; }
tell 'on any number of threads' threads
shaped() { # the covered share of a lattice, as it is measured
  printf 'dimension = 2; measure = { covered = { method = "rows"; points = 40000.0; }; };\n' > "$tmp/c.scene" && ends 0 "$randpack" measure "$tmp/shapes.xyz" --scene "$tmp/c.scene" --out "$tmp/covered" &&
    convert "$tmp/shapes.xyz" "$tmp/s.raw" --cells 200 && raw 40000 "$tmp/s.raw" > "$tmp/counts" &&
    awk -v want="$(value covered "$tmp/covered")" '$1 > 0 { n += $2 } END { print n / 40000, want; exit !((n / 40000 - want) ^ 2 < 1e-16) }' "$tmp/counts" > "$tmp/told" || { cat "$tmp/told"; return 1; }
}
tell 'shapes cover the points that covered counts' shaped
heap() { # a finite pack: its volume in the cuboid around it
  convert "$tmp/heap.xyz" "$tmp/heap.nrrd" --step 0.25 && eval "set -- $(field sizes "$tmp/heap.nrrd")" && raw $(($1 * $2 * $3)) "$tmp/heap.nrrd" > "$tmp/counts" &&
    awk -v cell="$(field 'space directions' "$tmp/heap.nrrd" | awk -F'[(,)]' '{ print $2 * $7 * $12 }')" '$1 == 1 { v = $2 * cell } END { want = 150 * 4 * 3.14159265358979 / 3; e = sqrt(0.06665 * 150 * 4 * 3.14159265358979) * 0.25 ^ 2; print v, want, e; exit !((v - want) ^ 2 < (3.5 * e) ^ 2) }' "$tmp/counts" > "$tmp/told" || { cat "$tmp/told"; return 1; }
}
tell 'a finite pack in voxels has its volume' heap

# --- Gmsh and POV-Ray
images() { # the images of deep.xyz that meet its box, by brute force: all, and cut
  awk 'NR == 2 { split($0, w, "\""); split(w[2], v, " "); L[1] = v[1]; L[2] = v[5]; L[3] = v[9] }
    NR > 2 { for (i = -1; i < 2; i++) for (j = -1; j < 2; j++) for (k = -1; k < 2; k++) { m[1] = i; m[2] = j; m[3] = k; s = 0; cut = 0
      for (a = 1; a <= 3; a++) { x = $(a + 1) + m[a] * L[a]; o = x < 0 ? x : x > L[a] ? x - L[a] : 0; s += o * o; cut += x < $5 || x > L[a] - $5 } if (s < $5 * $5) { all++; cuts += cut > 0 } } }
    END { print all, cuts }' "$1"
}
script() {
  convert "$tmp/deep.xyz" "$tmp/deep.geo" && grep -q '^// the pack was moved' "$tmp/deep.geo" && [ "$(grep -c '^Sphere' "$tmp/deep.geo")" -ge 200 ] &&
    [ "$(grep -c '^part() = BooleanIntersection' "$tmp/deep.geo")" -gt 50 ] && [ "$(grep -c '^Physical Volume' "$tmp/deep.geo")" = 3 ] && [ "$(grep -c '^      Periodic Surface' "$tmp/deep.geo")" = 3 ] || return 1
  # its spheres, moved back, are the images of the moved pack
  awk '/^\/\/ the pack was moved by/ { for (k = 1; k <= 3; k++) s[k] = $(k + 6) }
    /^Box/ { split($0, w, /[{},]/); for (k = 1; k <= 3; k++) L[k] = w[k + 4] }
    /^Sphere/ { split($0, w, /[{},]/); for (k = 1; k <= 3; k++) { x = w[k + 1] - s[k]; while (x < -1e-9) x += L[k]; while (x >= L[k] - 1e-9) x -= L[k]; p[k] = x }
      key = sprintf("%.6f %.6f %.6f", p[1], p[2], p[3]); if (!(key in seen)) { seen[key] = 1; n++ } } END { print n; exit n != 150 }' "$tmp/deep.geo" > "$tmp/told" || { cat "$tmp/told"; return 1; }
}
tell 'the script of Gmsh has the particles' script
grazes() { # no sphere's extent is nearer to a face than it would be at best, or than a tenth of the smallest radius
  awk '/^Box/ { split($0, w, /[{},]/); for (k = 1; k <= 3; k++) L[k] = w[k + 4] } /^Sphere/ { split($0, w, /[{},]/)
    for (k = 1; k <= 3; k++) for (e = -1; e < 2; e += 2) for (f = 0; f < 2; f++) { d = w[k + 1] + e * w[5] - f * L[k]; if (d < 0) d = -d; if (!(k in near) || d < near[k]) near[k] = d } }
    END { for (k = 1; k <= 3; k++) bad += near[k] < L[k] / 600; exit bad }' "$tmp/deep.geo"
}
tell 'and no face that only grazes one' grazes
shrunk() { # the wanted gap, exactly, and the fraction that the script tells
  convert "$tmp/deep.xyz" "$tmp/gap.geo" --gap 0.3 && printf 'dimension = 3; measure = { nearest = {}; };\n' > "$tmp/n.scene" && ends 0 "$randpack" measure "$tmp/deep.xyz" --scene "$tmp/n.scene" --out "$tmp/n" &&
    awk -F'[{},]' -v gap="$(value min_gap "$tmp/n")" '/^Sphere/ { r[$5] = 1 } END { d = (0.3 - 2 * gap) / 2; for (x in r) { n++; bad += (x - 1 + d) ^ 2 > 1e-16 && (x - 0.6 + d) ^ 2 > 1e-16 } exit !(n == 2 && !bad) }' "$tmp/gap.geo" &&
    grep -q '^// particles were made smaller, from fraction 0.3 to 0.[12]' "$tmp/gap.geo"
}
tell 'a gap makes all particles smaller' shrunk
touching() {
  printf '2\nLattice="9 0 0 0 9 0 0 0 9" Properties=type:S:1:pos:R:3:radius:R:1\nA 1 2 3 1\nA %s 2 3 1\n' "$1" > "$tmp/t.xyz"
  refused "$2" "$randpack" convert "$tmp/t.xyz" "$tmp/x.geo"
}
tell 'spheres that touch' touching 3 'particles touch, the least gap is 0, and no element fits between; give --gap, as --gap 0.05'
tell 'spheres that overlap' touching 2.5 'particles overlap, the least gap is -0.5, and no element'
tell 'a gap too large' refused 'a gap of 3 leaves nothing of a particle of radius 1; give a smaller --gap' "$randpack" convert "$tmp/t.xyz" "$tmp/x.geo" --gap 3
seams() { # away from the face that cuts, on both sides of the box
  local at want
  for at in '0.5 1' '9.5 -1'; do
    printf '1\nLattice="10 0 0 0 10 0 0 0 10" Properties=type:S:1:pos:R:3:radius:R:1\nA %s 5 5 1\n' "${at% *}" > "$tmp/t.xyz"
    convert "$tmp/t.xyz" "$tmp/t.geo" && [ "$(grep -c '^Sphere' "$tmp/t.geo")" = 2 ] && [ "$(grep -cF "Atan2(0, ${at#* })" "$tmp/t.geo")" = 2 ] || return 1
  done
}
tell 'the seams of spheres point away from the faces' seams
small() { # micrometres in metres
  awk 'NR == 2 { split($0, w, "\""); split(w[2], v, " "); for (k = 1; k <= 9; k++) v[k] *= 1e-6; printf "Lattice=\"%.17g 0 0 0 %.17g 0 0 0 %.17g\" Properties=type:S:1:pos:R:3:radius:R:1\n", v[1], v[5], v[9]; next }
    NR > 2 { printf "%s %.17g %.17g %.17g %.17g\n", $1, $2 * 1e-6, $3 * 1e-6, $4 * 1e-6, $5 * 1e-6; next } { print }' "$tmp/deep.xyz" > "$tmp/small.xyz"
  convert "$tmp/small.xyz" "$tmp/small.geo" && grep -qx 'Mesh.ScalingFactor = 1e-07;' "$tmp/small.geo" &&
    awk -F'[{},]' '/^Sphere/ { r[sprintf("%.9f", $5)]++ } END { for (x in r) { n++; bad += x + 0 != 10 && x + 0 != 6 } exit !(n == 2 && !bad) }' "$tmp/small.geo"
}
tell 'a pack in metres is scripted in its own unit' small
flat_script() { convert "$tmp/shapes.xyz" "$tmp/shapes.geo" && grep -q '^Disk' "$tmp/shapes.geo" && [ "$(grep -c 'Plane Surface' "$tmp/shapes.geo")" -ge 40 ] && [ "$(grep -c '^      Periodic Curve' "$tmp/shapes.geo")" = 2 ]; }
tell 'shapes are scripted as polygons' flat_script
picture() {
  convert "$tmp/deep.xyz" "$tmp/deep.pov" && read -r all cut <<< "$(images "$tmp/deep.xyz")" && [ "$(grep -c '^sphere' "$tmp/deep.pov")" = $((all - cut)) ] && [ "$(grep -c '^intersection { sphere' "$tmp/deep.pov")" = "$cut" ] && [ "$cut" -gt 50 ] || { echo "$all $cut"; return 1; }
}
tell 'the scene of POV-Ray has the images that meet the box' picture
others() { convert "$tmp/shapes.xyz" "$tmp/shapes.pov" && grep -q 'prism' "$tmp/shapes.pov" && grep -q '^cylinder' "$tmp/shapes.pov" && convert "$tmp/heap.xyz" "$tmp/heap.pov" && [ "$(grep -c '^sphere' "$tmp/heap.pov")" = 150 ] && ! grep -q intersection "$tmp/heap.pov"; }
tell 'and shapes, and finite packs' others
place() { mkdir -p "$tmp/else" && cp "$tmp/deep.xyz" "$tmp/else" && convert "$tmp/else/deep.xyz" "$tmp/else/deep.pov" && cmp "$tmp/deep.pov" "$tmp/else/deep.pov"; }
tell 'the same pack in another folder gives the same bytes' place
exit $failed
