#!/bin/bash
# tests/check-full.sh: disks that are full, folders that cannot be written, streams that are closed: the old file or the new one, whole,
# and one line; nothing where there is nothing to complain of.
. tests/tell.sh
cat > "$tmp/all.scene" <<'END'
dimension = 2; seed = 3; realizations = 2; save = true; fraction = 0.4;
species = ( { name = "A"; radius = 1.0; number = 60; }, { name = "B"; radius = 0.5; number = 40; } );
make = { method = "rsa"; };
shake = { radius = 0.1; sweeps = 2; };
measure = { rdf = { reach = 3.0; }; K = { reach = 3.0; }; nearest = {}; partials = { reach = [2.5]; }; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "chain"); } );
END
cat > "$tmp/long.scene" <<'END'
dimension = 3; fraction = 0.63; species = ( { name = "A"; radius = 1.0; number = 20000; } );
make = { method = "crm"; growth = 0.001; }; measure = { rdf = {}; };
END
ends 0 "$randpack" run "$tmp/all.scene" --out "$tmp/all" || failed=1
line() { [ "$(wc -l < "$tmp/err")" = 1 ] && grep -qE "$1" "$tmp/err" || { echo "wanted one line with: $1"; cat "$tmp/err"; return 1; }; }

# --- a full disk, for each file that a run writes
full() {
  local d=$tmp/full-$1 others
  mkdir "$d" && echo old > "$d/$1" && ln -s /dev/full "$d/$1.part" || return 1
  ends 1 "$randpack" run "$tmp/all.scene" --out "$d" && line "$1: cannot be written: No space left" &&
    [ "$(cat "$d/$1")" = old ] && ! ls "$d" | grep -q 'part$' || return 1
  for others in $(ls "$d" | grep -vx "$1"); do cmp "$d/$others" "$tmp/all/$others" || return 1; done
}
for name in $(ls "$tmp/all"); do tell "a full disk keeps the old $name, and what else is there is whole" full "$name"; done
limited() ( ulimit -f "$1"; shift; exec "$@" )
too_large() { # a limit on sizes is told like a full disk, although it has a signal
  ends 1 limited 2 "$randpack" run "$tmp/all.scene" --out "$tmp/limit" && line 'cannot be written: File too large' &&
    ! ls "$tmp/limit" | grep -q 'part$'
}
tell 'a limit on the size of files' too_large
if (unshare -m true) 2> "$tmp/err" && unshare -m sh -c "mount -t tmpfs -o size=16k none '$tmp/limit'" 2> "$tmp/err"; then
  small_disk() {
    unshare -m sh -c "mount -t tmpfs -o size=16k none '$tmp/limit' && '$randpack' run '$tmp/all.scene' --out '$tmp/limit'
      s=\$?; ls '$tmp/limit' > '$tmp/left'; for f in \$(cat '$tmp/left'); do cmp '$tmp/limit/'\$f '$tmp/all/'\$f || s=9; done; exit \$s" \
      > "$tmp/out" 2> "$tmp/err" < /dev/null
    [ $? = 1 ] && line 'cannot be written: No space left' && ! grep 'part$' "$tmp/left"
  }
  tell 'a small disk fills: what is there is whole' small_disk
else
  echo 'SKIP: no small disk can be mounted here'
fi
for verb in help version 'help make.crm' "plan $tmp/all.scene" 'theory py --phi 0.5 --at 2' 'theory contact --phi 0.3' 'theory structure --phi 0.3'; do
  printed() { local s=0; "$randpack" $verb > /dev/full 2> "$tmp/err" < /dev/null || s=$?; [ $s = 1 ] && line 'the standard output cannot be written'; }
  tell "${verb%% /*} onto a full disk" printed
  closed() { local s=0; "$randpack" $verb >&- 2> "$tmp/err" < /dev/null || s=$?; [ $s = 1 ] && line 'the standard output cannot be written'; }
  tell "${verb%% /*} with no standard output" closed
done

# --- a pipe that nobody reads
unread() { # unread COMMAND...: into a pipe whose reader has gone; its status is left in $tmp/status, its words in $tmp/err
  local s=0
  mkfifo "$tmp/pipe" || return 1
  : < "$tmp/pipe" &
  exec 3> "$tmp/pipe"
  wait $!
  "$@" >&3 2> "$tmp/err" < /dev/null || s=$?
  exec 3>&-
  echo $s > "$tmp/status"
  rm "$tmp/pipe"
}
quiet() { unread "$randpack" help && [ "$(cat "$tmp/status")" = 141 ] && [ ! -s "$tmp/err" ]; }
tell 'a closed pipe ends help by its signal, without a word' quiet
deaf() ( trap '' PIPE; unread "$randpack" help; [ "$(cat "$tmp/status")" = 1 ] && line 'the standard output cannot be written' )
tell 'where that signal is ignored, in one line' deaf

# --- standard streams that are closed are no files
streams() {
  local s=0
  "$randpack" run "$tmp/all.scene" --out "$tmp/streams" <&- >&- 2>&- || s=$?
  [ $s = 0 ] && diff -r "$tmp/all" "$tmp/streams"
}
tell 'closed streams: the same files' streams
words() { # a complaint does not go into a table
  local d=$tmp/words s=0
  mkdir "$d" && ln -s /dev/full "$d/sweep.tsv.part" && "$randpack" run "$tmp/all.scene" --out "$d" <&- >&- 2>&- || s=$?
  [ $s = 1 ] && ! grep -rl randpack: "$d"
}
tell 'nor do words go into them' words

# --- a folder that cannot be written is told before anything is computed
cannot() { # cannot REASON DIRECTORY COMMAND...
  local reason=$1 d=$2
  shift 2
  ends 1 timeout 10 "$@" run "$tmp/long.scene" --out "$d" && line "^randpack: $d: cannot be written: $reason"
}
: > "$tmp/file"
chmod 755 "$tmp"
tell 'a file' cannot 'Not a directory' "$tmp/file" "$randpack"
tell 'a folder in a file' cannot 'Not a directory' "$tmp/file/new" "$randpack"
tell 'a folder that cannot be made' cannot 'No such file or directory' /proc/randpack/new "$randpack"
tell 'a name that is too long' cannot 'File name too long' "$tmp/$(printf 'n%.0s' $(seq 300))" "$randpack"
nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
if [ "$(id -u)" = 0 ] && "${nobody[@]}" "$randpack" --version > "$tmp/out" 2>&1; then
  mkdir -m 755 "$tmp/mine"
  tell "somebody else's folder" cannot 'Permission denied' "$tmp/mine" "${nobody[@]}" "$randpack"
  tell "a folder in somebody else's" cannot 'Permission denied' "$tmp/mine/new" "${nobody[@]}" "$randpack"
elif [ "$(id -u)" != 0 ]; then
  mkdir -m 555 "$tmp/mine"
  tell 'a folder that is only to be read' cannot 'Permission denied' "$tmp/mine" "$randpack"
else
  echo 'SKIP: nobody cannot run the command here, so no folder was closed to it'
fi
exit $failed
