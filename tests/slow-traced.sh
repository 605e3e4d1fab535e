#!/bin/bash
# tests/slow-traced.sh: every maker and every measure under valgrind.
. tests/memory.sh
. tests/small.sh
small_scenes "$tmp"
for scene in "$tmp"/*.scene; do
  name=$(basename "$scene" .scene)
  tell "the scene $name under valgrind" clean "$name" "$tmp/of-$name/summary.tsv" "$randpack" run "$scene" --threads 1 --out "$tmp/of-$name"
done
exit $failed
