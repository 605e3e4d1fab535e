#!/bin/bash
# tests/check-command.sh: what the command prints, stores, writes and returns.
. tests/tell.sh

# --- theory
prints() { # prints TEXT COMMAND...
  local text=$1
  shift
  ends 0 "$@" && diff <(printf '%b' "$text") "$tmp/out" && [ ! -s "$tmp/err" ]
}
tell 'theory py at phi = 0.575' prints '2 7.12802768166\n4 1.55505783164\n20 0.994573015909\n' \
  "$randpack" theory py --phi 0.575 --at 2,4,20
tell 'no pair below contact' prints '0 0\n1 0\n1.99999999999 0\n' \
  "$randpack" theory py --phi 0.575 --at 0,1,1.99999999999
many() { # every column of a wide table has its name, and its name alone
  printf 'dimension = 3; theory = { curves = ["py", "well-stirred", "willis", "willis-kanaun"]; phi = [%s]; step = 1.0; reach = 3.0; };\n' \
    "$(seq -s, -f 0.%03g 11 74)" > "$tmp/many.scene"
  ends 0 "$randpack" run "$tmp/many.scene" --out "$tmp/many" && awk -F'\t' '/^#/ { next } !names { names = NF; for (i = 1; i <= NF; i++) if (twice[$i]++) bad = 1 }
    NF != names { bad = 1 } END { exit bad || names != 257 }' "$tmp/many/theory.tsv"
}
tell 'a table of 256 curves has 257 names' many
tell 'the well-stirred line' prints '1.5 0\n2 1\n7.25 1\n' "$randpack" theory well-stirred --phi 0.1 --at 1.5,2,7.25
tell 'several fractions, each behind its comment' prints '# phi 0.3\n2 2.34693877551\n4 1.00566266382\n# phi 0.4\n2 3.33333333333\n4 1.14166050085\n' \
  "$randpack" theory py --phi 0.3,0.4 --at 2,4
beyond() {
  ends 0 "$randpack" theory py --phi 0.7 --at 2 && [ "$(wc -l < "$tmp/out")" = 1 ] && grep -q 'note: no pack' "$tmp/err"
}
tell 'a note where no pack has the curve' beyond
equations() {
  ends 0 "$randpack" theory contact --phi 0.3,0.49 && [ "$(grep -c '^carnahan-starling' "$tmp/out")" = 2 ]
}
tell 'contact values by the equations of state' equations

# --- help
helps() { ends 0 "$randpack" "$@" && grep -q 'randpack run SCENE' "$tmp/out" && [ ! -s "$tmp/err" ]; }
tell 'help' helps help
tell '--help' helps --help
tell '--help behind a verb' helps run --help
tell 'no word at all' helps
version() { ends 0 "$randpack" --version && grep -qxE 'randpack [0-9]+\.[0-9]+\.[0-9]+' "$tmp/out"; }
tell '--version' version
keys() { # every key of a scene that tests/bad names is explained
  "$randpack" help > "$tmp/help"
  for key in dimension seed realizations species fraction make.method measure.rdf.step; do
    grep -q "^  $key " "$tmp/help" || { echo "$key"; return 1; }
  done
}
tell 'help names the keys' keys
narrow() { # the help, and that of each entry
  "$randpack" help > "$tmp/all"
  for name in $(sed -n 's/^  \(\(make\|shake\|measure\|theory\)\.[A-Za-z0-9_-]*\): .*/\1/p' "$tmp/all"); do "$randpack" help "$name"; done > "$tmp/each"
  [ "$(grep -c '^Example:' "$tmp/each")" -gt 40 ] && ! grep -hE '^.{81}|^ {6,}$| $' "$tmp/all" "$tmp/each" && grep -qE '^ {31}[^ ]' "$tmp/each"
}
tell 'no line of help is wider than 80' narrow

examples() { # the example of each entry is right in one of these scenes
  local name dim rest bad=0
  for name in $(sed -n 's/^  \(\(make\|shake\|measure\|theory\)\.[A-Za-z0-9_-]*\): .*/\1/p' "$tmp/all"); do
    "$randpack" help "$name" | sed '1,/^Example:/d' > "$tmp/example"
    while read -r dim rest; do
      case $name in make.*) rest=${rest%make *} ;; esac
      { echo "dimension = $dim; $rest"; cat "$tmp/example"; } > "$tmp/example.scene"
      "$randpack" plan "$tmp/example.scene" > "$tmp/out" 2> "$tmp/err" && continue 2
    done << 'END'
3 species = ( { radius = 1.0; number = 400; } ); fraction = 0.2; make = { method = "rsa"; };
3 species = ( { radius = 1.0; } ); fraction = 0.2;
3 species = ( { radius = 1.0; number = 400; } ); make = { method = "gravity"; };
3 species = ( { radius = 1.0; number = 400; } ); fraction = 0.2; make = { method = "gravity"; };
2 species = ( { radius = 1.0; number = 400; } ); fraction = 0.2; make = { method = "relax"; };
2 species = ( { radius = 1.0; number = 400; } ); fraction = 0.2; make = { method = "points"; };
2 species = ( { radius = 1.0; number = 4; } ); fraction = 0.2;
END
    echo "$name: $(cat "$tmp/example")"
    bad=1
  done
  return $bad
}
tell 'the examples of help are right' examples
groups() {
  local word
  for word in run plan measure merge view plot theory; do
    ends 0 "$randpack" help $word && grep -q "^  randpack $word " "$tmp/out" && [ "$(grep -c '^  randpack ' "$tmp/out")" = 1 ] || { echo "$word"; return 1; }
  done
  for word in 'make make.crm:' 'shake shake.metropolis:' 'measure measure.rdf:' 'theory theory.py:' 'species species.radius' 'window window.shape' 'make make.method' 'theory theory.phi'; do
    ends 0 "$randpack" help "${word% *}" && grep -q "^  ${word#* } " "$tmp/out" || { echo "$word"; return 1; }
  done
  "$randpack" plan "$tmp/wrong.scene" 2>&1 | sed 's/.*known here: //' | tr ' ' '\n' > "$tmp/known"
  [ "$(wc -l < "$tmp/known")" = 10 ] && diff <(sort "$tmp/known") <("$randpack" help species | sed -n 's/^  species\.\([a-z]*\) .*/\1/p' | sort)
}
echo 'dimension = 3; species = ( { raduis = 1.0; } ); measure = {};' > "$tmp/wrong.scene"
tell 'help of verbs, groups and species' groups
tell 'help of what is not there' refused 'help foo: no entry has this name; see' "$randpack" help foo

# --- lattices
shells() {
  ends 0 "$randpack" run figures/lattice/lattice-shells.scene --out "$tmp/shells" || return 1
  diff <(printf '%s\n' '2 6' '2.8284 12' '3.4641 8' '4 6' '4.4721 24' '4.8990 24' '5.6569 12' '6 30') \
    <(grep -v '^[#R]' "$tmp/shells/shells.tsv" | head -8 | awk '{ r = sprintf("%.4f", $1); sub(/\.0000$/, "", r); print r, $2 }')
}
tell 'the shells of the simple cubic lattice' shells

# --- what a scene stores, makes and writes
scene() { # scene NAME TEXT, all of one length, so that reading them costs the same
  printf '%-600s\n' "$2" > "$tmp/$1.scene"
}
one='species = ( { radius = 1.0; number = 400; } ); fraction = 0.3; make = { method = "rsa"; };'
two='species = ( { radius = 1.0; number = 200; }, { radius = 1.0; number = 200; } ); fraction = 0.3;
make = { method = "rsa"; };'
scene flat "dimension = 2; $one measure = { contact = {}; };"
scene deep "dimension = 3; $one measure = { contact = {}; };"
scene pair "dimension = 3; $two measure = { contact = {}; };"
scene rdf "dimension = 3; $one measure = { rdf = { reach = 5.0; }; }; save = true;"
bytes() { "$randpack" plan "$tmp/$1.scene" | awk '$1 == "store" { print $2 }'; }
tell 'two dimensions store 16 bytes a particle' test "$(bytes flat)" = 16
tell 'three store 24' test "$(bytes deep)" = 24
tell 'a second species adds its index' test "$(bytes pair)" = 26
fingerprint() { "$randpack" plan "$tmp/$1.scene" | grep '^fingerprint'; }
tell 'what is not measured is not in the fingerprint' test "$(fingerprint deep)" != "$(fingerprint rdf)"

# The command once more, linked so that it counts what it asks for.
${CC:-gcc} -fopenmp -Ibuild/c tests/counted.c build/obj/*.o -Wl,--wrap=pairs_count,--wrap=memory \
  -lconfig -lfftw3 -lz -lgsl -lgslcblas -lm $(nm build/obj/ranks.o | grep -q MPI_Init && mpicc --showme:link) -o "$tmp/counted" || failed=1
counted() { # counted NAME [SETTING]...: run the scene and leave calls, reach, pairs, bytes in variables
  local name=$1
  shift
  rm -rf "$tmp/$name"
  COUNTED=$tmp/counts ends 0 "$tmp/counted" run "$tmp/$name.scene" --threads 1 --out "$tmp/$name" "$@" || return 1
  eval "$(tr ' ' '\n' < "$tmp/counts")"
}
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }
only_contact() {
  counted deep && [ "$(ls "$tmp/deep")" = summary.tsv ] && [ "$calls" -gt 0 ] &&
    less "$reach" "$("$randpack" plan "$tmp/deep.scene" | sed -n 's/.*contact (R < \([0-9.]*\)).*/\1/p')"'0000001' ||
    { echo "reach $reach"; ls "$tmp/deep"; return 1; }
}
tell 'a scene of contact alone writes no table and counts within the range of its plan' only_contact
nothing() {
  scene none "dimension = 3; $one measure = { coordination = {}; };"
  counted none && [ "$calls" = 0 ] && [ "$(ls "$tmp/none")" = summary.tsv ]
}
tell 'a scene without pairs counts none' nothing
dimensions() {
  counted flat && local flat=$bytes && counted deep && less $((flat + 400 * 8 - 1)) "$bytes"
}
tell 'two dimensions allocate less than three' dimensions
species() {
  counted deep && local b=$bytes && counted pair && less "$((b + 400 * 2 - 1))" "$bytes"
}
tell 'one species allocates no index of species' species
reach_costs() {
  counted rdf && local p=$pairs && counted rdf --set measure.rdf.reach=2.5 && less "$pairs" $((p / 4))
}
tell 'a shorter reach counts fewer pairs' reach_costs
brute() { # pairs nearer than 5 in pack-0.xyz, by brute force
  awk -v reach=5 'NR == 2 { split($0, w, /[" ]/); L = w[2] }
    NR > 2 { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
    function near(d) { return d > L / 2 ? d - L : d < -L / 2 ? d + L : d }
    END { for (i = 1; i <= n; i++) for (j = 1; j < i; j++)
      c += near(x[j] - x[i]) ^ 2 + near(y[j] - y[i]) ^ 2 + near(z[j] - z[i]) ^ 2 < reach ^ 2
      print c }' "$1/pack-0.xyz"
}
row_pairs() {
  counted rdf && [ "$(value pairs "$tmp/rdf")" = "$(brute "$tmp/rdf")" ] && [ "$pairs" = "$(value pairs "$tmp/rdf")" ]
}
tell 'the row pairs is the brute-force count' row_pairs
as_planned() {
  local f name
  for f in figures/lattice/lattice-n1.scene figures/rsa/pack-?d.scene figures/lattice/rsa-K.scene "$tmp/rdf.scene" "$tmp/deep.scene"; do
    name=${f##*/}
    ends 0 "$randpack" run "$f" --set realizations=2 --out "$tmp/planned/$name" || return 1
    "$randpack" plan "$f" | sed -n 's/^write\t *//p' | tr ' ' '\n' | sed 's/pack-K.xyz/pack-0.xyz\npack-1.xyz/' | sort |
      diff - <(ls "$tmp/planned/$name" | sort) || { echo "$f"; return 1; }
  done
}
tell 'what is written is what was planned' as_planned

# --- packs out and in again
measured_again() { # measured_again NAME SCENE
  scene "$1" "$2"
  local a=$tmp/$1-run b=$tmp/$1-again
  ends 0 "$randpack" run "$tmp/$1.scene" --out "$a" &&
    ends 0 "$randpack" measure "$a"/pack-?.xyz --scene "$tmp/$1.scene" --out "$b" || return 1
  for f in "$b"/*.tsv; do
    diff <(grep -vE '^(attempts|trials)' "$a/${f##*/}") "$f" || return 1
  done
  [ "$(ls "$b" | wc -l)" -gt 1 ] && ! ls "$b" | grep -q xyz
}
all='rdf = { reach = 4.5; }; K = { reach = 3.0; }; I = { reach = 4.0; step = 0.5; }; nearest = {};
histogram = { centre = "random"; windows = 500; }; order = {}; coordination = {};'
tell 'packs of spheres measure the same when read back' measured_again spheres \
  "dimension = 3; realizations = 3; $one save = true; measure = { $all contact = {}; };"
tell 'packs of discs too' measured_again discs \
  "dimension = 2; realizations = 2; $one save = true; measure = { $all contact = {}; };"
tell 'packs of two sizes in a flat box too' measured_again sizes \
  "dimension = 3; realizations = 2; seed = 77; box = [2.0, 1.5, 1.0];
   species = ( { name = \"AP\"; radius = 1.0; mass = 0.8; density = 1.95; },
               { name = \"Al\"; radius = 0.37; mass = 0.2; density = 2.7; } );
   number = 900; fraction = 0.25; make = { method = \"rsa\"; }; save = true; measure = { $all };"

# --- status 1, and files whole or not at all
beyond_saturation() {
  scene dense 'dimension = 2; species = ( { radius = 1.0; number = 500; } ); fraction = 0.6;
    make = { method = "rsa"; }; measure = { contact = {}; };'
  ends 1 "$randpack" run "$tmp/dense.scene" --out "$tmp/dense" && [ "$(wc -l < "$tmp/err")" = 1 ] &&
    grep -qE '[0-9]+ of 500 placed, fraction 0\.5[0-9]+' "$tmp/err" && [ -z "$(ls "$tmp/dense" 2> /dev/null)" ]
}
tell 'a fraction beyond saturation: status 1, and what was reached' beyond_saturation
not_written() { # not_written REASON COMMAND...
  local reason=$1
  shift
  ends 1 "$@" && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -q "cannot be written: $reason" "$tmp/err" || { cat "$tmp/err"; return 1; }
}
: > "$tmp/file"
tell 'a file where the directory should be' not_written 'Not a directory' \
  "$randpack" run "$tmp/deep.scene" --out "$tmp/file/new"
tell 'a directory that cannot be made' not_written '' "$randpack" run "$tmp/deep.scene" --out /proc/randpack/new
deep_directory() { ends 0 "$randpack" run "$tmp/deep.scene" --out "$tmp/a/b//c/" && [ -s "$tmp/a/b/c/summary.tsv" ]; }
tell 'a directory that is not there is made' deep_directory
full_disk() { # full_disk TABLE: the device is full when it is written
  local d=$tmp/full-$1
  mkdir "$d" && echo old > "$d/$1" && ln -s /dev/full "$d/$1.part"
  not_written 'No space left' "$randpack" run "$tmp/rdf.scene" --out "$d" &&
    [ "$(cat "$d/$1")" = old ] && ! ls "$d" | grep -q part
}
for table in rdf.tsv summary.tsv pack-0.xyz; do
  tell "a full disk keeps the old $table whole" full_disk "$table"
done
limited() ( trap '' XFSZ; ulimit -f 4; exec "$@" )
too_large() {
  not_written 'File too large' limited "$randpack" run "$tmp/rdf.scene" --out "$tmp/limit" && [ -z "$(ls "$tmp/limit")" ]
}
tell 'a disk that fills in the middle of a file leaves nothing' too_large

# --- progress
silent() { ends 0 "$randpack" run "$tmp/deep.scene" --out "$tmp/p" && [ ! -s "$tmp/err" ] && [ ! -s "$tmp/out" ]; }
tell 'silent when nobody looks' silent
if script -qec true /dev/null < /dev/null > /dev/null 2>&1; then
  shown() { script -qec "$randpack run $tmp/deep.scene --set realizations=3 --out $tmp/p" /dev/null < /dev/null | grep -q '3 of 3'; }
  tell 'progress on a terminal' shown
fi
# A first pack, as the README shows it.
tried() {
  examples/try.sh "$randpack" "$tmp/try" > "$tmp/out" 2>&1 && [ -s "$tmp/try/cut.png" ] || { cat "$tmp/out"; return 1; }
  local shown=0 quantity value error
  while read -r quantity value error; do
    grep -qE "^$quantity +$value +$error$" "$tmp/out" || { echo "$quantity is not $value $error"; return 1; }
    shown=$((shown + 1))
  done < <(sed -n '/^which makes `examples/,/^with a standard/p' README.md | grep '^    ')
  [ $shown = 3 ]
}
tell 'make try shows what the README shows' tried
exit $failed
