#!/bin/bash
# tests/check-picture.sh: pictures of packs and of tables: what is in them, whatever files are called, and what is left if it fails.
. tests/tell.sh
if ! gnuplot --version > /dev/null 2>&1; then
  echo 'SKIP: no gnuplot, so no pictures'
  exit 0
fi
view() { ends 0 "$randpack" view "$@" && [ ! -s "$tmp/err" ] && [ ! -s "$tmp/out" ]; }
# How many areas of this colour an SVG has: discs and shapes, not the key.
areas() { grep -c "<polygon fill = 'rgb($1)'" "$2"; }
first='170, 210, 245' second='240, 180, 110'
said() { local file=$1 words; shift; for words; do grep -qF ">$words<" "$file" || { echo "no words: $words"; return 1; }; done; }

# --- packs to look at
cat > "$tmp/discs.scene" <<'XXX'
dimension = 2; seed = 3; species = ( { name = "A"; radius = 1.0; number = 60; }, { name = "B"; radius = 0.5; number = 90; } );
fraction = 0.4; box = [1.5, 1.0]; realizations = 2; make = { method = "rsa"; order = "large first"; }; measure = { coordination = {}; }; save = true;
XXX
cat > "$tmp/spheres.scene" <<'XXX'
dimension = 3; seed = 4; species = ( { name = "A"; radius = 1.0; number = 40; }, { name = "B"; radius = 0.5; number = 160; } );
fraction = 0.3; make = { method = "rsa"; order = "large first"; }; measure = { coordination = {}; }; save = true;
XXX
cat > "$tmp/shapes.scene" <<'XXX'
dimension = 2; seed = 5; fraction = 0.6; make = { method = "penetrable"; }; measure = { covered = {}; }; save = true;
species = ( { name = "P"; radius = 1.0; number = 30; shape = { kind = "polygon"; sides = 5; }; },
            { name = "S"; radius = 1.0; number = 30; shape = { kind = "superellipse"; aspect = 1.5; m = 1.5; }; } );
XXX
for s in discs spheres shapes; do "$randpack" run "$tmp/$s.scene" --out "$tmp/$s" || failed=1; done
discs=$tmp/discs/pack-0.xyz spheres=$tmp/spheres/pack-0.xyz shapes=$tmp/shapes/pack-0.xyz

# Discs of a species that reach into the box, images and all; with plane, those of its section across z, which is half way up.
expected() { # expected FILE SPECIES [plane]
  awk -v want="$2" -v plane="${3:+1}" '
    NR == 2 { match($0, /Lattice="[^"]*/); split(substr($0, RSTART + 9), s, " "); X = s[1]; Y = s[5]; Z = s[9] }
    NR > 2 && $1 == want {
      for (m = -1; m <= 1; m++) {
        d = $4 + m * Z - Z / 2; r = $5
        if (plane) { if (d * d >= r * r) continue; r = sqrt(r * r - d * d) } else if (m) continue
        for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) {
          x = $2 + i * X; y = $3 + j * Y
          ex = x < 0 ? x : x > X ? x - X : 0; ey = y < 0 ? y : y > Y ? y - Y : 0
          n += plane || !plane ? (ex * ex + ey * ey < r * r) : 0
        }
      }
    }
    END { print n + 0 }' "$1"
}
counted() { # counted SVG FILE [plane]
  local a b
  a=$(expected "$2" A "${3:-}") b=$(expected "$2" B "${3:-}")
  [ "$(areas "$first" "$1")" = "$a" ] && [ "$(areas "$second" "$1")" = "$b" ] ||
    { echo "$(areas "$first" "$1") $(areas "$second" "$1"), not $a $b"; return 1; }
}
flat() { view "$discs" -o "$tmp/flat.svg" && counted "$tmp/flat.svg" "$discs" && said "$tmp/flat.svg" x y 'A: 60, radius 1' 'B: 90, radius 0.5'; }
tell 'discs in their colours, images over the sides too' flat
note() { grep -q '>150 particles, fraction 0.4, box [0-9.]* x [0-9.]*; lengths as in the file<' "$tmp/flat.svg"; }
tell 'below them the number, the fraction and the box' note
section() { view "$spheres" --cut z=0.5 -o "$tmp/cut.svg" && counted "$tmp/cut.svg" "$spheres" plane && said "$tmp/cut.svg" x y; }
tell 'the discs of a section are those of its spheres, by species' section
other_section() { view "$spheres" --cut x=0.25 -o "$tmp/x.svg" && said "$tmp/x.svg" y z; }
tell 'a section across x shows y and z' other_section
formed() {
  view "$shapes" -o "$tmp/shapes.svg" && local p s && p=$(areas "$first" "$tmp/shapes.svg") s=$(areas "$second" "$tmp/shapes.svg") &&
    [ "$p" -ge 30 ] && [ "$p" -le 60 ] && [ "$s" -ge 30 ] && [ "$s" -le 60 ] || { echo "$p $s"; return 1; }
  grep -q 'fill-opacity' "$tmp/shapes.svg"
}
tell 'shapes are drawn, and seen through where they overlap' formed
frames() {
  cat "$tmp"/discs/pack-?.xyz > "$tmp/both.xyz"
  view "$tmp/both.xyz" --frame 1 -o "$tmp/frame.svg" && view "$tmp/discs/pack-1.xyz" -o "$tmp/alone.svg" &&
    cmp "$tmp/frame.svg" "$tmp/alone.svg" && ! cmp -s "$tmp/frame.svg" "$tmp/flat.svg"
}
tell 'a pack of a file with two' frames

# --- colours
cat > "$tmp/row.xyz" <<'XXX'
6
Lattice="20 0 0 0 20 0 0 0 20" pbc="T T T" Properties=species:S:1:pos:R:3:radius:R:1
A 0.5 5 5 1
A 2.5 5 5 1
A 4.5 5 5 1
A 18.5 5 5 1
A 10 10 10 1
A 12.05 10 10 1
XXX
neighbours() {
  view "$tmp/row.xyz" --color coordination=0.001 -o "$tmp/z.svg" && said "$tmp/z.svg" '0: 2' '1: 2' '2: 2' 'neighbours, gap up to 0.001 (a_i + a_j)' &&
    view "$tmp/row.xyz" --color coordination=0.03 -o "$tmp/z.svg" && said "$tmp/z.svg" '1: 4' '2: 2'
}
tell 'neighbours within a gap, over the side of the box too' neighbours
sizes() { view "$discs" --color size -o "$tmp/size.svg" && said "$tmp/size.svg" radius '0.5 to 0.562: 90' '0.938 to 1: 60'; }
tell 'by size' sizes
twisted() { # squares side by side with a gap of .01, and a third away
  sed 's/, /\n/g' > "$tmp/squares.xyz" <<<'3, Lattice="20 0 0 0 20 0 0 0 2" pbc="T T F" Properties=species:S:1:pos:R:3:radius:R:1:angle:R:1 shape_A="polygon:4", A 5 5 0 1 0.78539816339745, A 6.7824538509055 5 0 1 0.78539816339745, A 12 12 0 1 0'
  view "$tmp/squares.xyz" --color coordination=0.006 -o "$tmp/z.svg" && said "$tmp/z.svg" '0: 1' '1: 2' &&
    view "$tmp/squares.xyz" --color coordination=0.004 -o "$tmp/z.svg" && said "$tmp/z.svg" '0: 3'
}
tell 'the gap of shapes is that of their sides' twisted

# --- formats
size() { od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }'; }
pictured() { # pictured FILE.png: a PNG that is whole, of some hundred pixels, and no single colour
  [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] && tail -c 12 "$1" | grep -qa IEND &&
    size "$1" | awk '{ exit !($1 > 500 && $2 > 300 && $1 < 4000 && $2 < 4000) }' && [ "$(stat -c %s "$1")" -gt 6000 ]
}
formats() {
  view "$discs" -o "$tmp/a.png" && pictured "$tmp/a.png" && view "$discs" -o "$tmp/a.PDF" &&
    head -c 5 "$tmp/a.PDF" | grep -q '%PDF-' && tail -c 6 "$tmp/a.PDF" | grep -q '%%EOF' && head -c 200 "$tmp/flat.svg" | grep -q '<svg'
}
tell 'a PNG, an SVG and a PDF' formats
true_ratio() { # the sides of the frame are as those of the box, 1.5
  sed -n "s/.*<path stroke='rgb(119, 119, 119)'  d='M\([0-9.]*\),\([0-9.]*\) L\([0-9.]*\),\([0-9.]*\) L\([0-9.]*\),\([0-9.]*\) .*/\1 \2 \3 \4 \5 \6/p" "$tmp/flat.svg" |
    awk '{ w = $5 - $1; h = $4 - $2; q = w / h; q = q < 0 ? -q : q; found = 1; exit !(q > 1.495 && q < 1.505) } END { if (!found) exit 1 }'
}
tell 'lengths are the same along both axes' true_ratio
space() {
  view "$spheres" -o "$tmp/space.svg" && [ "$(grep -c '<image ' "$tmp/space.svg")" = 1 ] &&
    said "$tmp/space.svg" x y z 2 'A: 40, radius 1' 'B: 160, radius 0.5' && view "$spheres" -o "$tmp/space.png" && pictured "$tmp/space.png" &&
    [ "$(stat -c %s "$tmp/space.png")" -gt 60000 ]
}
tell 'spheres in space are an image with a bar and a key' space
again() {
  cp "$tmp/space.png" "$tmp/one.png"
  view "$spheres" -o "$tmp/space.png" && cmp "$tmp/one.png" "$tmp/space.png"
}
tell 'twice the same bytes' again
finite() {
  sed 's/pbc="T T T"/pbc="F F F"/' "$spheres" > "$tmp/finite.xyz"
  view "$tmp/finite.xyz" --cut y=0.5 -o "$tmp/finite.svg" && said "$tmp/finite.svg" x z && [ "$(areas "$first" "$tmp/finite.svg")" -gt 3 ] &&
    grep -q '>200 particles, cut at y = [-0-9.]*; lengths as in the file<' "$tmp/finite.svg"
}
tell 'a finite pack, cut' finite

# --- names
odd="$tmp/a b'c\"d"$'\n'"e\`touch $tmp/evil\`"
named() {
  mkdir -p "$odd" && cp "$discs" "$odd/p q.xyz" && view "$odd/p q.xyz" -o "$odd/new/x y.png" && pictured "$odd/new/x y.png" &&
    (cd "$odd" && "$randpack" view 'p q.xyz' -o '-x.svg' && grep -q '</svg>' ./-x.svg) && [ ! -e "$tmp/evil" ] &&
    ! find "$odd" -name '*.part' | grep .
}
tell 'files with blanks, quotes, newlines and a leading dash' named
species() {
  sed "s|^A |it's\"\`touch\$tmp/evil\`<\&>\\\\n |" "$discs" > "$tmp/odd.xyz"
  view "$tmp/odd.xyz" -o "$tmp/odd.svg" && grep -qF "it's\"\`touch\$tmp/evil\`&lt;&amp;" "$tmp/odd.svg" && [ ! -e "$tmp/evil" ]
}
tell 'names of species are texts and nothing else' species

# --- what is refused
tell 'another ending' refused 'not a format of pictures; give png, svg or pdf' "$randpack" view "$discs" -o "$tmp/a.jpg"
tell 'no ending' refused 'not a format of pictures' "$randpack" view "$discs" -o "$tmp/png.d/a"
usage() { ends 2 "$@" && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -q ' wants .* -o FILE.png' "$tmp/err"; }
tell 'no name of a picture' usage "$randpack" view "$discs"
tell 'no table' usage "$randpack" plot -o "$tmp/a.png"
tell 'a cut of discs' refused 'a pack in the plane; leave --cut out' "$randpack" view "$discs" --cut z=0.5 -o "$tmp/no.png"
for cut in z z= z=2 z=-0.1 z=nan z=0.5x q=0.5 0.5; do
  tell "a cut at $cut" refused 'a part of the side from 0 to 1' "$randpack" view "$spheres" --cut $cut -o "$tmp/no.png"
done
for color in colour coordination= coordination=-1 coordination=1x coordinations; do
  tell "colours by $color" refused 'give species, size, coordination' "$randpack" view "$spheres" --color $color -o "$tmp/no.png"
done
tell 'a pack too many' refused 'has 2 packs; give --frame 0 to 1' "$randpack" view "$tmp/both.xyz" --frame 2 -o "$tmp/no.png"
tell 'a pack that is no number' refused 'give a whole number' "$randpack" view "$tmp/both.xyz" --frame -1 -o "$tmp/no.png"
tell 'a file that is no pack' refused ';' "$randpack" view "$tmp/discs.scene" -o "$tmp/no.png"
tell 'a picture of a run in another format' refused 'give png, svg or pdf' "$randpack" run "$tmp/discs.scene" --plot=gif --out "$tmp/no"
tell 'an option of another verb' refused '--plot is no option of plan' "$randpack" plan "$tmp/discs.scene" --plot
tell 'a cut of a run' refused '--cut is no option of run' "$randpack" run "$tmp/discs.scene" --cut z=0.5
nothing_left() { ! ls -d "$tmp"/no* "$tmp"/*.part "$tmp"/png.d 2> /dev/null | grep .; }
tell 'nothing was left of these' nothing_left

# --- gnuplot is missing, or fails
fails() { # fails LINE PICTURE COMMAND...: status 1, one line; of the picture the old one
  local line=$1 picture=$2
  shift 2
  echo old > "$picture"
  ends 1 "$@" && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -qE "$line" "$tmp/err" && [ "$(cat "$picture")" = old ] && [ ! -e "$picture.part" ] ||
    { cat "$tmp/err"; return 1; }
}
missing='^randpack: gnuplot is needed for pictures; apt-get install gnuplot-nox$'
tell 'no gnuplot: a line that says what to do' fails "$missing" "$tmp/old.png" env PATH=/nonexistent "$randpack" view "$discs" -o "$tmp/old.png"
before() {
  fails "$missing" "$tmp/old.png" env PATH=/nonexistent "$randpack" run "$tmp/discs.scene" --plot --out "$tmp/unplotted" && [ ! -e "$tmp/unplotted" ]
}
tell 'and before a run begins' before
mkdir "$tmp/bin"
false_gnuplot() { printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\n%s\n' "$1" > "$tmp/bin/gnuplot" && chmod +x "$tmp/bin/gnuplot"; }
with_false() { false_gnuplot "$1" && fails "$2" "$tmp/old.png" env PATH="$tmp/bin:$PATH" "$randpack" view "$discs" -o "$tmp/old.png"; }
tell 'a warning of gnuplot is our error' with_false 'printf "\n\ngnuplot> x\n        ^\n         line 3: warning: odd\n\n" >&2; cat; printf "</svg>IEND"' \
  'old.png: gnuplot cannot draw it: line 3: warning: odd$'
tell 'so is a status' with_false 'exit 3' 'old.png: gnuplot cannot draw it'
tell 'so is a signal' with_false 'kill -9 $$' 'old.png: gnuplot cannot draw it: it was stopped'
tell 'a part of a picture is none' with_false 'printf "\211PNG"' 'old.png: cannot be written: gnuplot wrote a part'
full() {
  ln -s /dev/full "$tmp/full.png.part"
  ends 1 "$randpack" view "$discs" -o "$tmp/full.png" && [ "$(wc -l < "$tmp/err")" = 1 ] && ! ls "$tmp" | grep -q '^full'
}
tell 'a full disk leaves nothing' full
own_settings() { # what a user has set for gnuplot changes nothing
  mkdir -p "$tmp/home" && echo 'set title "mine"; set grid' > "$tmp/home/.gnuplot"
  HOME=$tmp/home GNUTERM=bogus GNUPLOT_DEFAULT_GDFONT=none view "$discs" -o "$tmp/own.svg" && cmp "$tmp/own.svg" "$tmp/flat.svg"
}
tell 'the settings of a user change nothing' own_settings

# --- pictures of tables
all_drawn() { # all_drawn DIR FORMAT: each table has its picture, made and shaken one
  local f name drawn=0
  for f in "$1"/*.tsv; do
    name=${f##*/}
    name=${name%.tsv}
    [ "$name" = summary ] && continue
    name=${name#made.}
    name=${name#shaken.}
    [ -s "$1/$name.$2" ] || { echo "no picture: $name"; return 1; }
    drawn=$((drawn + 1))
  done
  ! ls "$1" | grep '\.part$' && [ $drawn -gt 0 ]
}
cat > "$tmp/many.scene" <<'XXX'
dimension = 2; seed = 6; species = ( { name = "A"; radius = 1.0; number = 60; }, { name = "B"; radius = 0.5; number = 60; } );
fraction = 0.4; realizations = 2; make = { method = "rsa"; };
measure = { rdf = { reach = 4.0; }; K = { reach = 3.0; }; I = { reach = 4.0; step = 0.5; }; nearest = {}; quotients = { steps = [0.2, 0.1]; };
  partials = { reach = [3.0]; step = 0.1; window = 2.0; }; histogram = { windows = 200; }; S2 = { reach = 3.0; step = 0.2; species = true; };
  S3 = { theta = [0.0, 90.0]; reach = 2.0; step = 0.5; samples = 10000; }; chords = {}; pores = {}; surface = {}; cluster = {}; structure = {}; };
theory = { curves = ["py"]; phi = [0.3, 0.4]; };
XXX
many() { ends 0 "$randpack" run "$tmp/many.scene" --plot=svg --out "$tmp/many" && all_drawn "$tmp/many" svg || { cat "$tmp/err"; return 1; }; }
tell 'a scene of many measures: a picture for each table' many
labelled() {
  said "$tmp/many/rdf.svg" 'R = r/a' 'g(R)' 'radial distribution function; R = r/a is the middle of a bin' 'many.scene, seed 6, packs 2' &&
    said "$tmp/many/K.svg" 'K(R)  in a^d' && said "$tmp/many/S2.svg" S2 S_am S_mm S2_A_B && said "$tmp/many/theory.svg" py_0.3 py_0.4 &&
    said "$tmp/many/partial.A-B.svg" 'g(R)' 'K(R)  in a^d' 'n(R)' && said "$tmp/many/partial.svg" A-A A-B B-B &&
    said "$tmp/many/S3.svg" 'theta = 0' 'theta = 90' R1 R2 S3
}
tell 'labels with units, keys, pairs of species together' labelled
bars() { # points are drawn by some versions with the bars, too
  local rows points
  rows=$(grep -vc '^[#R]' "$tmp/many/rdf.tsv") points=$(grep -c "<use xlink:href='#gpPt6'" "$tmp/many/rdf.svg")
  [ "$rows" -gt 100 ] && { [ "$points" = "$rows" ] || [ "$points" = $((2 * rows)) ]; } || { echo "$points points, $rows rows"; return 1; }
}
tell 'as many points as the table has rows' bars
cat > "$tmp/shaken.scene" <<'XXX'
dimension = 2; seed = 7; species = ( { name = "A"; radius = 1.0; number = 60; } ); fraction = 0.4; realizations = 2; make = { method = "rsa"; };
shake = { rule = "metropolis"; radius = 0.1; sweeps = 4; marks = [1, 2]; }; measure = { rdf = { reach = 4.0; }; contact = {}; };
XXX
shaken() {
  ends 0 "$randpack" run "$tmp/shaken.scene" --plot=svg --out "$tmp/shaken" && all_drawn "$tmp/shaken" svg && said "$tmp/shaken/rdf.svg" made shaken 'g(R)' &&
    said "$tmp/shaken/shaking.svg" contact M && [ ! -e "$tmp/shaken/made.rdf.svg" ]
}
tell 'made and shaken are one picture' shaken
swept() {
  ends 0 "$randpack" run "$tmp/shaken.scene" --set 'sweep=({key="fraction";values=[0.2,0.3,0.4];},{key="shake.rule";values=["metropolis","chain"];})' \
    --plot=svg --out "$tmp/swept" && all_drawn "$tmp/swept" svg &&
    said "$tmp/swept/sweep.svg" fraction 'rule = metropolis' 'rule = chain' shaken.contact && said "$tmp/swept/rdf.svg" 'fraction = 0.2, rule = chain' &&
    said "$tmp/swept/rdf@0.2@chain.svg" made shaken
}
tell 'a sweep: each table, all combinations together, and a grid' swept
crowded() { # so many fractions at eleven radii; how many curves and quantities are in the table alone
  ends 0 "$randpack" run "$tmp/shaken.scene" --set "sweep=({key=\"fraction\";values=[$1];},{key=\"shake.radius\";values=[0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1.0,1.1];})" \
    --set 'shake.marks=[1]' --set shake.sweeps=1 --plot=svg --out "$tmp/crowded" || return 1
  more=$(sed -n 's/.*[; >]\([0-9]*\) more in the table<.*/\1/p' "$tmp/crowded/sweep.svg")
}
counted() { # of ten curves eight are drawn
  crowded 0.1,0.15,0.2,0.25,0.3,0.35,0.36,0.37 || return 1
  local eight=${more:-0}
  crowded 0.1,0.15,0.2,0.25,0.3,0.35,0.36,0.37,0.38,0.4 && [ "$more" = $((eight + 2)) ]
}
tell 'curves that have no colour left are counted' counted
only_new() {
  rm "$tmp"/many/*.svg && cp "$tmp/many/rdf.tsv" "$tmp/many/old.tsv"
  ends 0 "$randpack" run "$tmp/many.scene" --set 'measure={K={reach=3.0;};}' --plot --out "$tmp/many" && [ "$(cd "$tmp/many" && echo *.png)" = 'K.png theory.png' ] &&
    pictured "$tmp/many/K.png"
}
tell 'tables that were there before are not drawn' only_new
measured() {
  ends 0 "$randpack" measure "$tmp"/discs/pack-?.xyz --scene "$tmp/many.scene" --set 'measure={rdf={reach=3.0;};}' --plot=pdf --out "$tmp/measured" &&
    head -c 5 "$tmp/measured/rdf.pdf" | grep -q '%PDF-'
}
tell 'packs from files too' measured
together() {
  ends 0 "$randpack" plot "$tmp/shaken/made.rdf.tsv" "$tmp/measured/rdf.tsv" -o "$tmp/two.svg" && said "$tmp/two.svg" 'g(R)' "$tmp/measured/rdf.tsv"
}
tell 'tables of two runs in one picture' together
empty() {
  printf 'R\tg\tg_err\n2\tnan\tnan\n' > "$tmp/empty.tsv"
  ends 1 "$randpack" plot "$tmp/empty.tsv" -o "$tmp/no.png" && grep -q 'nothing to draw' "$tmp/err" && [ ! -e "$tmp/no.png" ]
}
tell 'a table without a number' empty
single() {
  printf 'R\tg\tg_err\n2\t0\t0\n' > "$tmp/single.tsv"
  ends 0 "$randpack" plot "$tmp/single.tsv" -o "$tmp/single.png" && pictured "$tmp/single.png"
}
tell 'a table of one number' single
tell 'a file that is no table' refused 'give a table that randpack wrote' "$randpack" plot "$discs" -o "$tmp/no.png"
exit $failed
