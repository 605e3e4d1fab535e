#!/bin/bash
# tests/slow-memory.sh: the unit tests under valgrind.
. tests/memory.sh
for file in tests/test_*.c; do
  name=${file#tests/test_} name=${name%.c}
  tell "$name under valgrind" clean "$name" "$tmp/$name.log" "build/unit/$name"
done
exit $failed
