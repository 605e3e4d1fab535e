# tests/kills.sh: sourced; what check-kill.sh and slow-kill.sh share. Jobs get their own group, or a shell that is not a person's
# would start them deaf to SIGINT.
. tests/tell.sh
set -m

# begin NAME ARGUMENT...: run the scene in the background, into $tmp/NAME; its number is in pid.
begin() {
  local name=$1
  shift
  "$randpack" run "$tmp/${name%%-*}.scene" --out "$tmp/$name" "$@" > "$tmp/out" 2> "$tmp/err" < /dev/null &
  pid=$!
}
# ended: wait for it; how it ended is in status.
ended() { status=0; wait "$pid" 2> /dev/null || status=$?; }
# used: the hundredths of a second of the processor that it has used so far.
used() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$1/stat" 2> /dev/null || echo 0; }
# after SECONDS NAME ARGUMENT...: begin, and kill it then; false if it was done before.
killed() {
  local seconds=$1
  shift
  begin "$@"
  sleep "$seconds"
  kill -KILL "$pid" 2> /dev/null
  ended
  [ $status = 137 ]
}
# whole NAME: all its files, and nothing else, in the bytes of the run that nobody disturbed.
whole() { diff -r "$tmp/${1%%-*}" "$tmp/$1"; }
# randomly LEAST MOST: seconds between these.
randomly() { awk -v a="$1" -v b="$2" -v r="$SRANDOM" 'BEGIN { printf "%.3f", a + (b - a) * r / 4294967296 }'; }
