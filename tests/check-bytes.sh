#!/bin/bash
# tests/check-bytes.sh: the same bytes on any number of threads and any processor, for every scene of
# figures/ with two realizations, and for some that no figure shows. The former run in the two variants that have
# nothing in common, the latter in all. A scene that is long even so has a line
# `# small: --set KEY=VALUE ...` with what makes it short.
. tests/bytes.sh
. tests/small.sh
all=("${variants[@]}") variants=(one old)
small() { same_bytes "$1" "$2" --set realizations=2 $(grep -q '^side' "$1" && echo --set side=20) $(sed -n 's/^# small://p' "$1"); }
for file in figures/*.scene; do
  name=${file##*/}
  tell "the same bytes of ${name%.scene} with ${variants[*]}" small "$file" "${name%.scene}"
done
variants=("${all[@]}")
small_scenes "$tmp"
for name in mixed discs shapes grown shaken; do
  tell "the same bytes of $name with ${variants[*]}" same_bytes "$tmp/$name.scene" $name
done
other_seed() { ends 0 "$randpack" run "$tmp/discs.scene" --set seed=0 --out "$tmp/seed" && ! diff -rq "$tmp/seed" "$tmp/one/discs"; }
tell 'another seed gives other bytes' other_seed > "$tmp/told"
grep -v '^Files' "$tmp/told"
exit $failed
