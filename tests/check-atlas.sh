#!/bin/bash
# tests/check-atlas.sh: long runs are taken from their records, and only from records that this program makes.
. tests/tell.sh
scene=$tmp/figures/finding/x.scene kept=$tmp/data/atlas/x
mkdir -p "$tmp/figures/finding" "$tmp/build/data" "$tmp/build/bin" "$tmp/tests"
cp tests/atlas.sh "$tmp/tests/" && ln -s "$(realpath "$randpack")" "$tmp/build/bin/randpack"
printf '# A long run.\n# atlas\ndimension = 2; seed = 5; realizations = 3; fraction = 0.3;\n' > "$scene"
printf 'species = ( { radius = 1.0; number = 60; } );\nmake = { method = "rsa"; };\nmeasure = { contact = {}; };\n' >> "$scene"
atlas() { (cd "$tmp" && tests/atlas.sh "$@" > log 2>&1); }
recorded() { atlas x && [ -e "$kept/summary.tsv" ] && [ "$(value realizations "$kept")" = 3 ] &&
  grep -q '^realizations	1	' "$kept/probe.tsv" && [ "$(wc -l < "$kept/record")" -ge 5 ]; }
tell 'a long run is recorded, with its first realization' recorded
once() { touch -d 2001-01-01 "$kept/record" && atlas x && [ "$kept/record" -ot "$scene" ]; }
tell 'once' once
tell 'the program of its record is believed' atlas --probe x
tell 'the same scene in other words is the same' bash -c "echo '# a word' >> '$scene'; cd '$tmp' && tests/atlas.sh --probe x"
other() { sed -i 's/^\(contact	[^	]*\)/\11/' "$kept/probe.tsv" && ! atlas --probe x && grep -q ': 1 of' "$tmp/log"; }
tell 'a program with other results is not' other
another() { rm -r "$kept" && atlas x && atlas --probe x && sed -i 's/seed = 5/seed = 6/' "$scene" && ! atlas --probe x &&
  grep -q 'another scene' "$tmp/log" && atlas x && atlas --probe x; }
tell 'another scene is recorded anew' another
part() { echo '# probe: --set measure={nearest={};}' >> "$scene" && atlas x && atlas --probe x && grep -q '^nearest	' "$tmp/build/data/x.probe/summary.tsv" &&
  ! grep -q '^contact	' "$tmp/build/data/x.probe/summary.tsv" && sed -i 's/^\(attempts	[^	]*\)/\11/' "$kept/probe.tsv" && ! atlas --probe x; }
tell 'a part of it will do, and is compared' part
for scene in $(grep -lx '# atlas' figures/*/*.scene); do
  name=$(basename "$scene" .scene)
  tell "$name has its record" cmp -s <(sed '/^#/d' "data/atlas/$name/record" 2> /dev/null) <(sed '/^ *#/d' "$scene")
done
