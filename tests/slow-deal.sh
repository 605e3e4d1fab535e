#!/bin/bash
# tests/slow-deal.sh: the model of chapter cost: five realizations of one length take two ranks as long as three of them take one.
# alone: a second test on the machine would take the second rank's processor.
. tests/tell.sh
[ "$(nproc)" -ge 2 ] || { echo 'SKIP: one processor, so two ranks are as slow as one'; exit; }
. tests/mpi.sh
wall() { local TIMEFORMAT=%R; { time ranks "$1" run "$tmp/long.scene" --set realizations=5 --out "$tmp/wall" > "$tmp/out" 2>&1; } 2>&1; }
dealt() {
  local one two
  for i in 1 2 3; do
    one=$(wall 1) two=$(wall 2)
    echo "one rank $one s, two ranks $two s; 3/5 is foretold"
    awk -v a="$one" -v b="$two" 'BEGIN { exit !(b / a > 0.5 && b / a < 0.75) }' && return
  done
  return 1
}
tell 'two ranks take three fifths of the time for five realizations' dealt
exit $failed
