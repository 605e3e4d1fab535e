#!/bin/bash
# tests/check-guide.sh: what the user's guide says is so: its commands are run, its keys, tables, rows, statuses and packages are those of
# the program, and the examples leave the tables that it names.
. tests/tell.sh
. tests/small.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
guide=src/guide/guide.nw root=$PWD
entries=$("$randpack" help | sed -n 's/^  \(\(make\|shake\|measure\|theory\)\.[A-Za-z0-9_-]*\): .*/\1/p')
unwrap() { awk -f paper/unwrap.awk; }
for entry in $entries; do "$randpack" help "$entry"; done | unwrap > "$tmp/entries"

# ---- its tables of keys: from TeX back to what the program prints, letter by letter
plain() { # TeX as tex.awk writes it -> text
  sed -E 's/\\textbackslash\{\}/\x01/g; s/\\textasciicircum\{\}/^/g; s/\\textasciitilde\{\}/~/g; s/\\textquotedbl\{\}/"/g; s/\\textquotesingle\{\}/'"'"'/g
    s/\\textbar\\allowbreak\{\}/|/g; s/\\textless\{\}/</g; s/\\textgreater\{\}/>/g; s/\\allowbreak\{\}//g; s/\\([{}#$%&_])/\1/g; s/\x01/\\/g'
}
keys() { # what is printed of keys, without its blanks and the words between
  "$randpack" help | unwrap | sed -n '/^Keys of a scene/,/^A scene:/p' | sed '1d;$d' | grep . | sed -E 's/^  //; s/^([^ ]+[^: ]) +/\1 /; s/; default ([^;]*)$/ \1/; s/; required$/ required/' | tr -s ' '
}
typeset() {
  "$randpack" help | unwrap | awk -f paper/tex.awk -f paper/keys.awk | sed -E '/^%/d; s/\\keyhead\{\\texttt\{(.*)\}\}\{(.*)\}$/\1: \2/; s/^\\texttt\{(.*)\} & (.*) & (.*)\\\\$/\1 \2 \3/' |
    plain | sed 's/ $//' | tr -s ' '
}
all_keys() { [ "$(keys | wc -l)" -gt 150 ] && diff <(keys) <(typeset); }
tell 'the table of keys has every key of the program, with its words and its default' all_keys
entry_keys() { # and so has each entry's own help
  local key
  typeset | sed 's/ .*//' > "$tmp/typeset"
  for key in $(sed -n '/^Keys:/,/^\(What\|Example\)/s/^  \([^ ]*\) .*/\1/p' "$tmp/entries" | sed 's/^make\.//' | sort -u); do
    grep -qE "^(make\.[a-z]+\.)?$(sed 's/\./\\./g' <<< "$key")\$" "$tmp/typeset" || { echo "$key"; return 1; }
  done
}
tell 'and every key that the help of an entry tells' entry_keys
species_keys() { # those of a species, which are typed: from the answer to a wrong one
  ! "$randpack" plan examples/first.scene --set 'species=({radiu=1.0;})' 2> "$tmp/err" &&
    diff <(sed -n 's/.*known here: //p' "$tmp/err" | tr ' ' '\n' | sort) \
      <(sed -n '/^key of a species/,/bottomrule/p' "$guide" | sed -n 's/^\(\[\[[^&]*\) & .*/\1/p' | grep -o '\[\[[a-z]*\]\]' | tr -d '[]' | sort)
}
tell 'the keys of a species' species_keys
packages() {
  diff <(make -pn help | sed -n 's/^PACKAGES := //p' | tr ' ' '\n' | sort) \
    <(sed -n '/^what & packages/,/bottomrule/p' "$guide" | grep -o '\[\[[a-z0-9-]*\]\]' | tr -d '[]' | sort)
}
tell 'the packages' packages
makers() {
  diff <(sed -n 's/^make\.//p' <<< "$entries" | sort) <(sed -n '/^\[\[method\]\] &/,/bottomrule/p' "$guide" | sed '1d; s/ & .*//' | grep -o '\[\[[a-z]*\]\]' | tr -d '[]' | sort)
}
tell 'the makers' makers

# ---- tables and rows: of scenes that have every measure, and of the examples
ends 0 bash -c ". tests/small.sh; small_scenes '$tmp'"
for scene in "$tmp"/*.scene; do
  "$randpack" run "$scene" --out "$tmp/made/$(basename "$scene" .scene)" > "$tmp/out" 2>&1 || { tell "$scene runs" false; cat "$tmp/out"; }
done
for example in first propellant concrete beads; do
  tell "the example $example runs" ends 0 "$randpack" run examples/$example.scene --out "$tmp/made/$example"
  tell "and says nothing" test ! -s "$tmp/err"
done
ends 0 "$randpack" run examples/concrete.scene --set 'measure={sections={};}' --out "$tmp/made/sections"
tell 'the example tomography runs' ends 0 "$randpack" measure examples/centres.txt --scene examples/tomography.scene --out "$tmp/made/tomography"
awk -f paper/tex.awk -f paper/files.awk "$tmp/entries" | plain > "$tmp/files.tex"
columns() { # of every table, the first columns are those that the guide tells of it
  local file name told status=0 tables=0
  for file in "$tmp"/made/*/*.tsv; do
    name=$(basename "$file" .tsv) name=${name%%@*} name=${name#made.} name=${name#shaken.} name=${name/.*-*/.A-B}
    case $name in summary | sizes | theory | sweep | shaking) continue ;; esac
    told=$(sed -n "s/^\(\\\\newcommand\\\\tablerows{\)\?\\\\texttt{$name\.tsv} & \\\\texttt{\(.*\)}\\\\\\\\\*\$/\2/p" "$tmp/files.tex")
    [ -n "$told" ] && [[ "$(grep -v '^#' "$file" | head -n 1 | tr '\t' ' ') " = "$told "* ]] || { echo "$file: $told"; status=1; }
    tables=$((tables + 1))
  done
  [ $tables -gt 100 ] && return $status
}
tell 'tables have the columns that it tells' columns
every_table() {
  sed -n 's/^\(\\newcommand\\tablerows{\)\?\\texttt{\([^}]*\)\.tsv} & .*/\2/p' "$tmp/files.tex" | sed 's/\.A-B$//' | while read -r name; do
    ls "$tmp"/made/*/*"$name"* > "$tmp/out" 2>&1 || echo "$name"
  done | diff - /dev/null
}
tell 'and there were all of these tables' every_table
rows() { # every row of a summary is told: by an entry, or in the list of others
  local name
  { sed -n 's/^  row \([^:. ]*\).*/\1/p' "$tmp/entries"
    sed -n '/^other row/,/bottomrule/p' "$guide" | sed 's/ & .*//' | grep -o '\[\[[^]]*\]\]' | tr -d '[]' | sed 's/\.SPECIES//; s/^NAME_X$/(phi|shell|I|exact|right|central|p|c|radial)_[0-9.e+-]+/; s/^NAME/.*/; s/X/[0-9]*/'
  } | sort -u | sed 's/.*/^&$/' > "$tmp/known"
  cut -f 1 "$tmp"/made/*/summary.tsv | grep -v '^\(#\|quantity\)' | sed 's/@.*//; s/^\(made\|shaken\|change\)\.//' | sort -u > "$tmp/found"
  # the names of species and pairs behind a point
  sed -E 's/\.([A-Za-z]+|[A-Za-z]+-[A-Za-z]+)$//' "$tmp/found" | sort -u | grep -vE -f "$tmp/known" | diff - /dev/null
}
tell 'rows of summaries are told' rows

# ---- the words about files, errors and ends
tree() { find "$tmp/made/$1" -type f -printf '%f\n' | sort | tr '\n' ' '; }
tell 'a run leaves its packs and its tables' test "$(tree propellant)" = 'pack-0.xyz pack-1.xyz pack-2.xyz pack-3.xyz partial.coarse-coarse.tsv partial.coarse-fine.tsv partial.fine-fine.tsv summary.tsv '
sizes() { head -n 5 "$tmp/made/concrete/sizes.tsv" | tail -n 1 | diff - <(printf 'species\ta\tnumber\tnumber_by_law\tvolume\tvolume_by_law\n'); }
tell 'sizes.tsv has the made and the wanted shares' sizes
curve() { awk -F'\t' '/^#/ || /^species/ { next } ($5 - $6) ^ 2 > 0.04 ^ 2 { bad = 1 } END { exit bad || NR < 50 }' "$tmp/made/concrete/sizes.tsv"; }
tell 'which agree' curve
near() { awk -v a="$(value "$1" "$tmp/made/$2")" -v b="$(value "$1" "$tmp/made/$3")" -v most="$4" 'BEGIN { exit !(a != "" && b != "" && (a / b - 1) ^ 2 < most ^ 2) }'; }
tell 'the beads seen through the window are those of the whole pack' near nearest tomography beads 0.005
tell 'and have as many others around them' near window_mean tomography beads 0.05
centres() { (cd "$tmp" && ln -sf "$root/examples" . && examples/centres.sh "$randpack" "$tmp/cut") | cmp - examples/centres.txt; }
tell 'the file of centres is the one that was made' centres
one_pack() { awk -F'\t' '$1 == "nearest" { exit $3 != "nan" }' "$tmp/made/tomography/summary.tsv"; }
tell 'one pack has no errors' one_pack
status() { # status WANTED SIGNAL: of a run that gets the signal while it grows, as a shell tells it
  local got=0
  timeout --preserve-status -s "$2" 1 "$randpack" run examples/first.scene --set make.growth=1e-5 --out "$tmp/stopped" > "$tmp/out" 2> "$tmp/err" || got=$?
  [ $got = "$1" ] && [ "$(wc -l < "$tmp/err")" = 1 ] && [ -d "$tmp/stopped/parts" ]
}
for end in '130 INT' '143 TERM' '129 HUP'; do
  # shellcheck disable=SC2086
  tell "status and signal $end, as the guide has them" status $end
done
has() { grep -q '{130} for Control-C, .*{143} for SIGTERM, .*{129} for a terminal' "$guide" && grep -q '^1 & not reached' "$guide" && grep -q '^2 & the input is wrong' "$guide"; }
tell 'and it has them' has
tell 'status 2' refused 'grwth is not a key of make' "$randpack" run examples/propellant.scene --set make.grwth=0.1

# ---- its commands, in a tree of their own; those of make last. deps, which installs packages, is left out.
tree=$tmp/tree
mkdir -p "$tree/build/bin" "$tmp/home" && ln -s "$root"/* "$tree/" 2> "$tmp/err"
rm "$tree/build" 2> "$tmp/err"
mkdir -p "$tree/build/bin" && cp "$randpack" "$tree/build/bin/randpack"
for part in c plain print obj lib; do [ ! -e build/$part ] || ln -s "$root/build/$part" "$tree/build/$part"; done
awk '/^\\begin\{terminal\}/ { inside = 1 } /^\\end\{terminal\}/ { inside = 0 }
  inside && /^\$ / { words = substr($0, 3); while (sub(/\\$/, "", words) && getline > 0) words = words $0; print words }' "$guide" > "$tmp/commands"
tell 'there are commands, each in its place' test "$(grep -c '^\$ ' "$guide")" = "$(wc -l < "$tmp/commands")" -a "$(wc -l < "$tmp/commands")" -gt 15
good() { (cd "$tree" && HOME=$tmp/home bash -eu -o pipefail -c "$1") > "$tmp/out" 2>&1 < /dev/null || { tail -n 3 "$tmp/out"; return 1; }; }
while read -r words; do tell "$words" good "$words"; done < <(grep -v '^make ' "$tmp/commands")
tell 'a jammed pack ends with 1' grep -qx 'status 1' <(cd "$tree" && bash -c "$(grep 'out jammed' "$tmp/commands")" 2>&1)
while read -r words; do tell "$words" good "${words/make deps /make }"; done < <(grep '^make ' "$tmp/commands")
tell 'installed, it runs' ends 0 "$tmp/home/.local/bin/randpack" --version

# ---- what is shown is not wider than the page
wide() { awk 'length > 96 { print FILENAME ": " $0; bad = 1 } END { exit bad }' $(sed -n 's/.*\\verbatiminput{\(examples[^}]*\)}.*/\1/p' "$guide"); }
tell 'the scenes that it shows fit on the page' wide
exit $failed
