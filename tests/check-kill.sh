#!/bin/bash
# tests/check-kill.sh: a run that is killed or stopped goes on to the same bytes; one that is told to stop ends by the signal, says so
# in one line, and leaves nothing half; a person sees how far it is.
. tests/kills.sh
cat > "$tmp/grown.scene" <<'END'
dimension = 3; seed = 3; realizations = 2; save = true; fraction = 0.6;
species = ( { name = "A"; radius = 1.0; number = 300; }, { name = "B"; radius = 0.7; number = 150; } );
make = { method = "crm"; growth = 0.006; rest = 20; };
measure = { rdf = { reach = 3.0; }; pressure = { warm = 20; blocks = 4; each = 20; }; };
END
cat > "$tmp/shaken.scene" <<'END'
dimension = 3; seed = 4; realizations = 2; save = true; fraction = 0.5;
species = ( { name = "A"; radius = 1.0; number = 400; } );
make = { method = "crm"; growth = 0.1; };
shake = { radius = 0.1; sweeps = 1200; every = 20.0; each = 2; marks = [10, 200]; samples = 2; apart = 100; };
measure = { rdf = { reach = 3.0; }; order = {}; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "chain"); } );
END

# --- killed
resumed() { # resumed SCENE THREADS SECONDS: kills, then to the end
  local name=$1-$2
  killed 3 "$3" "$name" --threads "$2" --checkpoint 0.02 || return 1
  begin "$name" --threads "$2" --checkpoint 0.02
  ended
  [ $status = 0 ] && [ ! -s "$tmp/err" ] && whole "$name"
}
for scene in grown shaken; do
  seconds=$(took $scene 1)
  for threads in 1 2; do
    tell "$scene on $threads threads, killed three times: the same bytes" resumed $scene $threads "$seconds"
  done
done

# --- told to stop, in the midst of the first realization, whatever the machine's speed
quarter=$(awk -v t="$( { TIMEFORMAT=%U; time "$randpack" run "$tmp/grown.scene" --out "$tmp/grown-time" --threads 1; } 2>&1)" \
  'BEGIN { print int(25 * t) }')
at_work() { while [ "$(used $pid)" -lt "$quarter" ] && kill -0 $pid 2> /dev/null; do sleep 0.01; done; }
states() { ls "$tmp/$1/parts" 2> /dev/null; }
stopped() { # stopped SIGNAL STATUS SETTING...: at a time at which it is at work
  local signal=$1 want=$2 name=grown-$1
  shift 2
  begin "$name" --threads 1 "$@"
  at_work
  kill -"$signal" $pid
  ended
  [ $status = "$want" ] && [ "$(wc -l < "$tmp/err")" = 1 ] && [ ! -s "$tmp/out" ] &&
    grep -qx 'randpack: interrupted after [01] of 2 realizations; run the same command again to go on' "$tmp/err" ||
    { echo "status $status"; cat "$tmp/err"; return 1; }
  ! find "$tmp/$name" -name '*.part' -o -name '*.tsv' | grep . || return 1
}
goes_on() { # goes_on NAME SETTING...: to the same bytes
  begin "$@"
  ended
  [ $status = 0 ] && whole "$1"
}
tell 'SIGTERM ends it by the signal, in one line, without a table' stopped TERM 143
tell 'and leaves the state of the realization at work' grep -q '^state-[01]-1$' <(states grown-TERM)
tell 'from which it goes on' goes_on grown-TERM
tell 'SIGINT too' stopped INT 130
tell 'and goes on' goes_on grown-INT --threads 2
tell 'SIGHUP, with nothing to be written' stopped HUP 129 --checkpoint 0
tell 'writes nothing' test ! -e "$tmp/grown-HUP/parts"
listens() { # to SIGTERM, the second that it asks for
  local tries=0
  until grep -q '^SigCgt:.*[4-7c-f]...$' "/proc/$pid/status" || [ $((tries += 1)) -gt 1000 ]; do sleep 0.01; kill -0 $pid || break; done
}
later() { # a scene that never comes: it can only wait. Two signals within a second are one stop, as timeout sends it; a later one is obeyed
  local first second
  [ -p "$tmp/never.scene" ] || mkfifo "$tmp/never.scene" || return 1
  begin never
  listens
  first=${EPOCHREALTIME/[.,]/}
  kill -INT $pid
  sleep 0.1
  kill -INT $pid
  second=${EPOCHREALTIME/[.,]/}
  sleep 2.1
  if ! grep -q '^State:.[RS]' "/proc/$pid/status"; then
    ended
    [ $((second - first)) -lt 900000 ] || { later; return; } # the machine was asleep between the two
    echo 'ended by the second'
    return 1
  fi
  kill -INT $pid
  for _ in $(seq 100); do kill -0 $pid 2> /dev/null && sleep 0.05; done
  kill -KILL $pid 2> /dev/null
  ended
  [ $status = 130 ]
}
tell 'two signals within a second are one, a later one ends it at once' later
deaf() { # who was started deaf to a signal stays so
  (trap '' TERM; exec "$randpack" run "$tmp/grown.scene" --out "$tmp/grown-deaf" --threads 1) &
  pid=$!
  at_work
  kill -TERM $pid
  ended
  [ $status = 0 ] && whole grown-deaf
}
tell 'a signal that was ignored stays so' deaf
cost() { # what is resumed is not done again: of the processor's time less than two thirds is left
  local all TIMEFORMAT=%U one=(--threads 1 --set realizations=1 --set save=false)
  all=$( { time "$randpack" run "$tmp/grown.scene" --out "$tmp/grown-all" "${one[@]}"; } 2>&1)
  begin grown-cost "${one[@]}"
  while [ "$(used $pid)" -lt "$(awk -v a="$all" 'BEGIN { print int(a * 60) }')" ] && kill -0 $pid; do sleep 0.01; done
  kill -TERM $pid
  ended
  [ $status = 143 ] || return 1
  local rest
  rest=$( { time "$randpack" run "$tmp/grown.scene" --out "$tmp/grown-cost" "${one[@]}"; } 2>&1)
  awk -v a="$all" -v b="$rest" 'BEGIN { exit !(b < a / 1.5) }' || { echo "$rest of $all"; return 1; }
}
tell 'what was done is not done again' cost
measuring() { # of packs that are measured nothing is kept
  "$randpack" measure "$tmp"/grown/pack-?.xyz --scene "$tmp/grown.scene" --out "$tmp/measured" > "$tmp/out" 2> "$tmp/err" < /dev/null \
    --set measure.pressure.each=1e6 &
  pid=$!
  listens
  sleep 0.1
  kill -TERM $pid
  ended
  [ $status = 143 ] && grep -q 'interrupted at .*; no table was written' "$tmp/err" && [ -z "$(ls "$tmp/measured" 2> /dev/null)" ]
}
tell 'measuring is stopped, too' measuring

# --- states that are not taken
foreign() { # foreign NAME COMMAND...: what the command has done to the states of a run does no harm
  local name=$1
  shift
  rm -rf "${tmp:?}/$name"
  begin "$name" --threads 1
  at_work
  kill -TERM $pid
  ended
  cd "$tmp/$name/parts" && "$@" && cd "$OLDPWD" && goes_on "$name"
}
damage() { for f in state-*; do printf 'x' | dd of="$f" bs=1 seek=5000 conv=notrunc 2> /dev/null || return 1; done; }
halve() { for f in state-*; do truncate -s 40% "$f" 2> /dev/null || truncate -s 9000 "$f"; done; }
another() { # a state of another seed
  rm -rf "${tmp:?}/grown-seed"
  begin grown-seed --threads 1 --set seed=4
  at_work
  kill -TERM $pid
  ended
  cp "$tmp"/grown-seed/parts/* .
}
tell 'a damaged state is not taken' foreign grown-damaged damage
tell 'nor half of one' foreign grown-half halve
tell 'nor one of another seed' foreign grown-other another
wrong() { refused "--checkpoint $1: give seconds, or 0 for none" "$randpack" run "$tmp/grown.scene" --checkpoint "$1"; }
for value in -1 1x nan ''; do tell "--checkpoint '$value' is wrong" wrong "$value"; done
tell '--checkpoint is of run' refused 'is not an option of plan' "$randpack" plan "$tmp/grown.scene" --checkpoint 3
full() { # the disk is full when a state is written: a note, and the results
  mkdir -p "$tmp/grown-full/parts"
  for k in 0 1; do for part in 1 2 3; do ln -s /dev/full "$tmp/grown-full/parts/state-$k-$part.part"; done; done
  begin grown-full --threads 1 --checkpoint 0.02
  ended
  [ $status = 0 ] && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -q 'note: .*state.* cannot be written: No space left' "$tmp/err" && whole grown-full
}
tell 'a state that cannot be written ends nothing' full

# --- what a person sees
if script -qec true /dev/null < /dev/null > /dev/null 2>&1; then
  seen() { # of both threads, the line rewritten, and never torn
    script -qec "stty cols 200; $randpack run $tmp/grown.scene --threads 2 --set make.growth=0.005 --out $tmp/seen" /dev/null < /dev/null > "$tmp/line"
    tr '\r' '\n' < "$tmp/line" | sed 's/ *$//' | grep . > "$tmp/lines"
    local one="$tmp/grown.scene: [012] of 2"
    grep -qE "^$one; realization [01]: fraction 0\.[0-9]{4} of 0\.6000, [0-9]+ collisions a particle(; [0-9]+ s left)?$" "$tmp/lines" &&
      grep -qE '; [0-9]+ s left$' "$tmp/lines" && [ "$(tail -1 "$tmp/lines")" = "$tmp/grown.scene: 2 of 2" ] &&
      ! grep -vE "^$one(; realization [01]: [^;]*)?(; [0-9]+ s left)?$" "$tmp/lines"
  }
  tell 'how far it is, and how long it will take' seen
  narrow() { # cut at the width of the terminal
    script -qec "stty cols 50; $randpack run $tmp/grown.scene --set realizations=1 --set make.growth=0.005 --out $tmp/seen" /dev/null < /dev/null |
      tr '\r' '\n' | awk 'length > 50 { bad = 1 } END { exit bad || NR < 3 }'
  }
  tell 'on a narrow terminal' narrow
else
  echo 'SKIP: no terminal by script, so no line was looked at'
fi
exit $failed
