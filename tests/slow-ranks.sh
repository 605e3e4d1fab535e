#!/bin/bash
# tests/slow-ranks.sh: a run by MPI has the bytes of a run without, for any number of ranks; one that loses workers, too; one that loses a
# rank goes on.
. tests/tell.sh
. tests/small.sh
. tests/mpi.sh
small_scenes "$tmp"
same() { # same SCENE K WORD...: the directory of K ranks is that of a run without
  local name=$1 k=$2
  shift 2
  [ -e "$tmp/$name" ] || ends 0 "$randpack" run "$tmp/$name.scene" --out "$tmp/$name" || return 1
  rm -rf "$tmp/by"
  ends 0 ranks "$k" run "$tmp/$name.scene" --out "$tmp/by" "$@" && diff -r "$tmp/$name" "$tmp/by"
}
for k in 1 2 3 5; do
  for name in mixed grown shaken; do tell "$name by $k ranks" same $name $k; done
done
tell 'each with two workers' same mixed 2 --threads 2
for name in discs shapes field lattice points fluid; do tell "$name by 2 ranks" same $name 2; done
printf 'dimension = 3; theory = { curves = ["py"]; phi = [0.3]; };\n' > "$tmp/theory.scene"
tell 'theory by 2 ranks' same theory 2
printf '%s\n' 'dimension = 2; seed = 6; realizations = 5; species = ( { radius = 1.0; number = 40; } ); fraction = 0.5;
make = { method = "rsa"; }; measure = { rdf = { reach = 4.0; }; };
sweep = ( { key = "fraction"; values = [0.4, 0.54, 0.7]; } ); unreached = "keep";' > "$tmp/unreached.scene"
tell 'what is not reached, by 3 ranks' same unreached 3
pieces() {
  ends 0 ranks 2 run "$tmp/mixed.scene" --realizations 0-2 --out "$tmp/piece" && ends 0 "$tmp/randpack" run "$tmp/mixed.scene" --realizations 3-4 --out "$tmp/piece" &&
    ends 0 "$randpack" run "$tmp/mixed.scene" --out "$tmp/piece" && diff -r "$tmp/mixed" "$tmp/piece"
}
tell 'pieces by ranks, by one process, and the rest without MPI' pieces
wrong() { # one line of ours, whatever mpirun adds
  ends 2 ranks 3 run "$tmp/mixed.scene" --set fraction=2 --out "$tmp/none" && [ "$(grep -c '^randpack: ' "$tmp/err")" = 1 ] && [ ! -e "$tmp/none" ]
}
tell 'a wrong scene is told once' wrong
unread() {
  ends 2 mpirun --oversubscribe -n 1 "$tmp/randpack" run "$tmp/mixed.scene" --out "$tmp/none" : -n 1 "$tmp/randpack" run "$tmp/none.scene" --out "$tmp/none" &&
    grep -q '^randpack: rank 1: .*none.scene: cannot be read' "$tmp/err"
}
tell 'a scene that one rank cannot read is told' unread
differ() {
  ends 2 mpirun --oversubscribe -n 1 "$tmp/randpack" run "$tmp/mixed.scene" --out "$tmp/none" : -n 1 "$tmp/randpack" run "$tmp/grown.scene" --out "$tmp/none" &&
    grep -q '^randpack: rank 1 has another scene' "$tmp/err" && [ -z "$(ls "$tmp/none" 2> /dev/null)" ]
}
tell 'and so is one that is another' differ

# --- losses
below() { # below PID: all processes that it has started, and those that these have
  local child
  for child in $(ps -o pid= --ppid "$1"); do echo "$child"; below "$child"; done
}
workers() { # of this mpirun: those of our program that have no child and a parent and a grandparent of it
  local pid parent
  for pid in $(below "$1"); do
    [ "$(ps -o comm= -p "$pid")" = randpack ] || continue
    parent=$(ps -o ppid= -p "$pid")
    [ "$(ps -o comm= -p $parent)" = randpack ] && [ "$(ps -o comm= -p $(ps -o ppid= -p $parent))" = randpack ] && echo "$pid"
  done
}
first_worker() { # wait for one
  local tries=0
  until worker=$(workers "$1" | head -1) && [ -n "$worker" ] || [ $((tries += 1)) -gt 200 ] || ! kill -0 "$1" 2> /dev/null; do sleep 0.1; done
  [ -n "$worker" ]
}
lose() { # lose K TIMES: kill a worker so many times
  local k=$1 times=$2 pid status=0
  ends 0 "$randpack" run "$tmp/long.scene" --out "$tmp/long" || return 1
  rm -rf "$tmp/lost"
  ranks "$k" run "$tmp/long.scene" --out "$tmp/lost" 2> "$tmp/err" &
  pid=$!
  for ((i = 0; i < times; i++)); do
    sleep 0.7
    first_worker $pid && kill -9 "$worker" || { echo 'no worker'; return 1; }
  done
  wait $pid || status=$?
  [ $status = 0 ] && diff -r "$tmp/long" "$tmp/lost" && [ "$(grep -c 'is lost: its worker was ended by signal 9; it is done again' "$tmp/err")" = "$times" ] &&
    grep -q 'realization [0-9]* (seed 8) is lost' "$tmp/err" || { cat "$tmp/err"; return 1; }
}
tell 'a worker that is killed costs its realization, which is told and done again' lose 2 1
tell 'two of them, of a single rank' lose 1 2
thrice() {
  local pid status=0
  ranks 1 run "$tmp/long.scene" --set realizations=1 --set species.[0].number=6000 --out "$tmp/thrice" 2> "$tmp/err" &
  pid=$!
  for i in 1 2 3; do sleep 0.5; first_worker $pid && kill -9 "$worker" || return 1; done
  wait $pid || status=$?
  [ $status = 1 ] && grep -q 'realization 0 (seed 8) was lost 3 times; the last time its worker was ended by signal 9' "$tmp/err" || { cat "$tmp/err"; return 1; }
}
tell 'what is lost three times is given up' thrice
rank_dies() { # parts are on disk by then, and the same command goes on; so many realizations that two seconds are not enough
  local pid rank tries=0 status=0 longer=(run "$tmp/long.scene" --set realizations=30)
  rm -rf "$tmp/dies"
  ends 0 "$randpack" "${longer[@]}" --out "$tmp/longer" || return 1
  ranks 2 "${longer[@]}" --out "$tmp/dies" 2> "$tmp/err" &
  pid=$!
  until ls "$tmp/dies/parts" 2> /dev/null | grep -qv part || [ $((tries += 1)) -gt 300 ]; do sleep 0.1; done
  local all
  all=$(below $pid)
  rank=$(for p in $all; do [ "$(ps -o comm= -p "$(ps -o ppid= -p "$p" | tr -d ' ')")" = mpirun ] && echo "$p"; done | tail -1)
  kill -9 "$rank" && { wait $pid || status=$?; }
  for p in $all; do
    tries=0
    while [ "$(ps -o comm= -p "$p")" = randpack ] && [ $((tries += 1)) -lt 50 ]; do sleep 0.1; done
    [ $tries -lt 50 ] || { ps -o pid,ppid,stat,cmd -p "$p"; return 1; }
  done
  [ $status != 0 ] && [ ! -e "$tmp/dies/summary.tsv" ] && touch -d 2001-01-01 "$tmp/dies/pack-0.xyz" && ends 0 ranks 3 "${longer[@]}" --out "$tmp/dies" &&
    diff -r "$tmp/longer" "$tmp/dies" && [ "$tmp/dies/pack-0.xyz" -ot "$tmp/long.scene" ]
}
tell 'a rank that is killed ends the run, nothing of it goes on, and the same command finishes it' rank_dies
script() {
  mkdir "$tmp/script" && cd "$tmp/script" || return 1
  MPIRUN='mpirun --oversubscribe -n 2' RANDPACK=$tmp/randpack bash "$OLDPWD/examples/mpi.sbatch" "$tmp/mixed.scene" && cd "$OLDPWD" && diff -r "$tmp/mixed" "$tmp/script/results"
}
tell 'the script for MPI' script
exit $failed
