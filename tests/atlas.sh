#!/bin/bash
# tests/atlas.sh NAME...: run these scenes of the folders of figures/ unless data/atlas/NAME holds them already, and put there their tables,
# the same of their first realization alone (the probe), and a record: the scene, and what it took.
# tests/atlas.sh --probe NAME: does the program of today make that first realization as it was recorded? Where even that is
# long, a line `# probe: --set KEY=VALUE ...` in the scene tells with what it is a part of it.
set -eu -o pipefail
field() { sed -n "s/^$1[[:space:]]*: //p" /proc/cpuinfo | head -1; }
scene() { echo figures/*/"$1.scene"; }
same_scene() { sed '/^#/d' "data/atlas/$1/record" 2> /dev/null | cmp -s - <(sed '/^ *#/d' "$(scene "$1")"); }
rows() { sed '/^#/d' "$1"; }
probe() { build/bin/randpack run "$(scene "$1")" --set realizations=1 $(sed -n 's/^# probe://p' "$(scene "$1")") --out "$2"; }
# compare RECORDED FRESH: how many rows that both have, and how many of the recorded are other or missing.
compare() {
  awk -F'\t' 'FNR == NR { old[$1] = $0; next } $1 in old { both++; other += old[$1] != $0; delete old[$1] }
    END { for (q in old) lost++; print both + 0, other + 0, lost + 0 }' <(rows "$1") <(rows "$2")
}
if [ "$1" = --probe ]; then
  name=$2
  same_scene "$name" || { echo "data/atlas/$name: recorded with another scene; make atlas"; exit 1; }
  probe "$name" "build/data/$name.probe"
  read -r both other lost < <(compare "data/atlas/$name/probe.tsv" "build/data/$name.probe/summary.tsv")
  ! grep -q '^# probe:' "$(scene "$name")" || lost=0
  [ "$both" -ge 3 ] && [ $((other + lost)) = 0 ] || {
    echo "data/atlas/$name: $((other + lost)) of $both rows of its first realization come out otherwise today; make atlas"; exit 1; }
  exit
fi
for name; do
  to=data/atlas/$name
  [ -z "${FRESH:-}" ] && same_scene "$name" && continue
  echo "  record $name"
  rm -rf "$to.new"
  mkdir -p data/atlas
  TIMEFORMAT='%U'
  took=$( { time build/bin/randpack run "$(scene "$name")" --out "$to.new" >&3; } 3>&1 2>&1 )
  probe "$name" "$to.new/probe"
  mv "$to.new/probe/summary.tsv" "$to.new/probe.tsv"
  rm -r "$to.new/probe"
  { echo "# processor: $(field 'model name')"
    echo "# date: $(date -u +%Y-%m-%d), seconds of the processor: $took"
    sed '/^ *#/d' "$(scene "$name")"; } > "$to.new/record"
  rm -rf "$to"
  mv "$to.new" "$to"
done
