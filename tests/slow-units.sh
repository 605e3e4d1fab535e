#!/bin/bash
# tests/slow-units.sh: the unit tests with as many particles and repetitions as they have room for, of the plain
# build, which is the one that is used.
. tests/tell.sh
export RANDPACK_SLOW=1
unit() { "build/unit/$1" > "$tmp/$1" 2>&1 && grep -q '^PASS:' "$tmp/$1" || { grep '^FAIL:' "$tmp/$1" | head; return 1; }; }
for file in tests/test_*.c; do
  name=${file#tests/test_} name=${name%.c}
  tell "$name, the long way" unit "$name"
done
exit $failed
