#!/bin/bash
# tests/slow-memory.sh: under valgrind, no unit test and no maker or measure decides by a byte that nobody has set, or
# touches memory that is not its own. A bare number that differs is no failure here: valgrind's long double is short.
. tests/tell.sh
. tests/small.sh
command -v valgrind > "$tmp/found" || { echo 'SKIP: valgrind is not installed, so nothing was run under it'; exit; }
export RANDPACK_SIMD=avx2 OMP_NUM_THREADS=1 RANDPACK_MEMORY=1
clean() { # clean NAME COMMAND...: whatever it finds itself, valgrind finds nothing
  local name=$1
  shift
  valgrind -q --error-exitcode=99 --log-file="$tmp/$name.valgrind" "$@" > "$tmp/$name.log" 2>&1 < /dev/null
  [ -s "$tmp/$name.log" ] && [ ! -s "$tmp/$name.valgrind" ] || { head -30 "$tmp/$name.valgrind"; return 1; }
}
for file in tests/test_*.c; do
  name=${file#tests/test_} name=${name%.c}
  tell "$name under valgrind" clean "$name" "build/unit/$name"
done
small_scenes "$tmp"
for scene in "$tmp"/*.scene; do
  name=$(basename "$scene" .scene)
  tell "the scene $name under valgrind" clean "$name" "$randpack" run "$scene" --threads 1 --out "$tmp/of-$name"
done
exit $failed
