# tests/kills.sh: sourced; what check-kill.sh and slow-kill.sh share. Jobs get their own group, and hear signals though the tests
# were started so that they hear none, by nohup or in the background.
. tests/tell.sh
set -m

# begin NAME ARGUMENT...: run the scene in the background, into $tmp/NAME; its number is in pid.
begin() {
  local name=$1
  shift
  env --default-signal=INT,TERM,HUP "$randpack" run "$tmp/${name%%-*}.scene" --out "$tmp/$name" "$@" > "$tmp/out" 2> "$tmp/err" \
    < /dev/null &
  pid=$!
}
# ended: wait for it; how it ended is in status.
ended() { status=0; wait "$pid" 2> /dev/null || status=$?; }
# used: the hundredths of a second of the processor that it has used so far.
used() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$1/stat" 2> /dev/null || echo 0; }
# took SCENE THREADS: seconds of a run that nobody disturbs, into $tmp/SCENE, or, if that is there, aside.
took() {
  local TIMEFORMAT=%R to=$tmp/$1
  [ ! -e "$to" ] || to=$tmp/aside
  { time "$randpack" run "$tmp/$1.scene" --out "$to" --threads "$2" --checkpoint 0 > "$tmp/out" 2>&1; } 2>&1
  rm -rf "$tmp/aside"
}
# killed TIMES MOST NAME ARGUMENT...: begin, and kill after random seconds up to MOST, so often. A run that is done before is done
# again.
killed() {
  local times=$1 most=$2 kills=0 rounds=0
  shift 2
  while [ $kills -lt "$times" ] && [ $rounds -lt $((9 * times)) ]; do
    begin "$@"
    sleep "$(awk -v most="$most" -v r="$SRANDOM" 'BEGIN { printf "%.3f", most * r / 4294967296 }')"
    kill -KILL "$pid" 2> /dev/null
    ended
    rounds=$((rounds + 1))
    if [ $status = 137 ]; then kills=$((kills + 1)); else rm -rf "${tmp:?}/$1"; fi
  done
  [ $kills = "$times" ]
}
# whole NAME: all its files, and nothing else, in the bytes of the run that nobody disturbed.
whole() { diff -r "$tmp/${1%%-*}" "$tmp/$1"; }
