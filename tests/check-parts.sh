#!/bin/bash
# tests/check-parts.sh: finished realizations are kept, taken, put together and refused; the bytes are those of one run.
. tests/tell.sh
. tests/small.sh
small_scenes "$tmp"
say() { printf '%s\n' "$2" > "$tmp/$1.scene"; } # say NAME TEXT
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR WORD...
merge() { ends 0 "$randpack" merge "${@:2}" --out "$tmp/$1"; }
say few 'dimension = 3; seed = 17; realizations = 7; save = true; species = ( { name = "A"; radius = 1.0; number = 80; } ); fraction = 0.3;
make = { method = "rsa"; }; measure = { rdf = { reach = 4.0; }; nearest = {}; };'
# Two combinations of three are beyond saturation, after their numbers that differ; packs are shaken, with marks.
say sweep 'dimension = 2; seed = 6; realizations = 5; species = ( { radius = 1.0; number = 40; } ); fraction = 0.5;
make = { method = "rsa"; }; shake = { radius = 0.1; sweeps = 4; marks = [1, 2]; }; measure = { rdf = { reach = 4.0; }; contact = {}; };
sweep = ( { key = "fraction"; values = [0.4, 0.54, 0.7]; }, { key = "shake.radius"; values = [0.1, 0.2]; } ); unreached = "keep";'
tables() { # tables A B: have two directories the same tables, and some?
  local a b
  a=$(cd "$1" && ls ./*.tsv) b=$(cd "$2" && ls ./*.tsv)
  [ "$a" = "$b" ] && for t in $a; do cmp "$1/$t" "$2/$t" || return 1; done
}

# --- pieces
pieces() { # pieces NAME SCENE FROM-TO FROM-TO...: made apart, the last first, and put together
  local name=$1 scene=$2 i=0 from=()
  shift 2
  run "$scene" "$name" || return 1
  for piece; do
    run "$scene" "$name-$i" --realizations "$piece" && ! ls "$tmp/$name-$i" | grep -q tsv || return 1
    from=("$tmp/$name-$i" "${from[@]}") i=$((i + 1))
  done
  merge "$name-all" "${from[@]}" && tables "$tmp/$name" "$tmp/$name-all" && [ ! -e "$tmp/$name-all/parts" ]
}
tell 'pieces of seven realizations' pieces few few 0-2 3 4,5-6
tell 'and of a single one each' pieces ones few 0 1 2 3 4 5 6
tell 'pieces of a sweep that is shaken, and not reached in parts' pieces sweep sweep 0 1-2 3-4
[ "$(awk -F'\t' '$1 ~ /^reached@/ { n[$2]++ } END { print n[0], n[1] }' "$tmp/sweep/summary.tsv")" != ' 6' ]
tell 'of which some are reached and some are not' test $? = 0
tell 'pieces of a box that is saturated' pieces discs discs 0-1 2-6
beside() { # pieces in one directory, which a run then finishes
  run few beside --realizations 5-6 && run few beside --realizations 1 && touch -d 2001-01-01 "$tmp"/beside/pack-{1,5,6}.xyz &&
    run few beside && diff -r "$tmp/few" "$tmp/beside" && [ "$tmp/beside/pack-5.xyz" -ot "$tmp/few.scene" ] &&
    [ ! "$tmp/beside/pack-0.xyz" -ot "$tmp/few.scene" ]
}
tell 'a run takes what is finished, and does the rest' beside
lost_pack() { run few lost --realizations 2-4 && rm "$tmp/lost/pack-3.xyz" && run few lost && diff -r "$tmp/few" "$tmp/lost"; }
tell 'what has lost its pack is made again' lost_pack
damaged() {
  run few damaged --realizations 0 && run few damaged --realizations 6 && local f
  for f in "$tmp"/damaged/parts/*-0; do printf x | dd of="$f" bs=1 seek=300 conv=notrunc status=none; done
  touch "$tmp/damaged/parts/0123456789abcdef-9.part"
  run few damaged && diff -r "$tmp/few" "$tmp/damaged"
}
tell 'what is damaged is made again' damaged
rows() { grep -v '^#' "$1/rdf.tsv"; }
other() { # parts of another scene are not taken, and do not harm
  sed 's/seed = 17/seed = 18/' "$tmp/few.scene" > "$tmp/else.scene" && run else other --realizations 0-6 && cp "$tmp/few.scene" "$tmp/else.scene" &&
    run else other && diff <(rows "$tmp/few") <(rows "$tmp/other") && [ ! -e "$tmp/other/parts" ]
}
tell 'those of another scene are not taken' other
set_seed() { run few set --realizations 0-6 --set seed=18 && run few set && diff -r "$tmp/few" "$tmp/set"; }
tell 'nor those of other settings' set_seed

# --- what a piece cannot be
while IFS='|' read -r piece words; do
  tell "--realizations $piece" refused "$words" "$randpack" run "$tmp/few.scene" --realizations "$piece" --out "$tmp/none"
done <<'END'
7|few.scene has 7, numbered from 0; give some of 0-6
1-7|few.scene has 7, numbered from 0; give some of 0-6
99999999999999999999|few.scene has 7, numbered from 0; give some of 0-6
3-2|--realizations 3-2: give numbers from 0, as
-1|--realizations -1: give numbers from 0, as
1-|give numbers from 0, as
1,,2|give numbers from 0, as
one|give numbers from 0, as
1 2|give numbers from 0, as
|give numbers from 0, as
END
say theory 'dimension = 3; theory = { curves = ["py"]; phi = [0.3]; };'
tell 'a scene that makes nothing has no pieces' refused 'makes none; leave the option out' \
  "$randpack" run "$tmp/theory.scene" --realizations 0 --out "$tmp/none"
tell 'nothing was written' test ! -e "$tmp/none"
theory() { run theory theory && [ "$(ls "$tmp/theory")" = $'summary.tsv\ntheory.tsv' ]; }
tell 'but is run' theory
jams() { # one realization that fails, in the second piece
  say jams "$(sed 's/fraction = 0.5;/fraction = 0.7;/; s/^sweep.*//' "$tmp/sweep.scene")"
  ends 1 "$randpack" run "$tmp/jams.scene" --out "$tmp/jams" && cp "$tmp/err" "$tmp/said" && [ -z "$(ls "$tmp/jams" 2> /dev/null)" ] &&
    ends 1 "$randpack" run "$tmp/jams.scene" --out "$tmp/jams-0" --realizations 0-2 && cmp "$tmp/err" "$tmp/said" &&
    ends 1 "$randpack" run "$tmp/jams.scene" --out "$tmp/jams-1" --realizations 3-4 &&
    ends 1 "$randpack" merge "$tmp/jams-1" "$tmp/jams-0" --out "$tmp/jams-all" && cmp "$tmp/err" "$tmp/said" && [ ! -e "$tmp/jams-all" ]
}
tell 'a failure is that of the whole run' jams

# --- what cannot be put together
tell 'merge of nothing' refused 'merge needs the directories of the pieces; see' "$randpack" merge
tell 'merge of a directory without pieces' refused "$tmp/few: holds no finished realizations; give" "$randpack" merge "$tmp/few" --out "$tmp/none"
tell 'missing ones' refused 'realizations are missing; make them with --realizations 0-2,4-6' "$randpack" merge "$tmp/few-1" --out "$tmp/none"
tell 'of another scene' refused 'differs from the first, a scene of another name; merge them separately' \
  "$randpack" merge "$tmp"/few-{0,1} "$tmp/discs-0" --out "$tmp/none"
set_piece() { run few set-1 --realizations 3 --set fraction=0.3; }
tell 'a piece with a setting' set_piece
tell 'of other settings' refused 'differs from the first, other settings; merge them separately' "$randpack" merge "$tmp"/few-0 "$tmp/set-1" --out "$tmp/none"
twice() { merge twice "$tmp"/few-{0,1,2,1} "$tmp/ones-4" && tables "$tmp/few" "$tmp/twice"; }
tell 'what is there twice and the same is taken' twice
# A program that is another one by a single letter of a fingerprint, and a record that is another one by a bit.
forged() { # forged NEW OLD PERL: OLD's pieces with their bytes changed by PERL, and a sum that is right
  rm -rf "${tmp:?}/$1" && cp -r "$tmp/$2" "$tmp/$1" && for f in "$tmp/$1"/parts/*; do
    perl -0777 -i -pe '$_ = substr($_, 0, -8); '"$3"'; use integer; my $h = 0xcbf29ce484222325;
      for my $c (unpack "C*", $_) { $h = ($h ^ $c) * 0x100000001b3 } $_ .= pack "q<", $h' "$f"
  done
}
forged same ones-3 ''
tell 'the sum of a file is understood' cmp "$tmp"/same/parts/* "$tmp"/ones-3/parts/*
forged code ones-3 's/(0\.1\.0.{9})([0-9a-f])/$1 . ($2 eq "a" ? "b" : "a")/se'
tell 'of another program' refused 'other code or another compiler; merge with the program' "$randpack" merge "$tmp/code" --out "$tmp/none"
forged bit ones-3 'substr($_, -9, 1) ^= "\1"'
tell 'what is there twice and not the same' refused "realization 3 is in $tmp/few-1 and, with other results, in $tmp/bit; one of them is wrong" \
  "$randpack" merge "$tmp"/few-{0,1,2} "$tmp/bit" --out "$tmp/none"
spoilt() { cp -r "$tmp/few-2" "$tmp/spoilt" && truncate -s -1 "$tmp"/spoilt/parts/*; }
spoilt
tell 'what is damaged' refused 'no finished realizations, or damaged; make them again' "$randpack" merge "$tmp"/few-{0,1} "$tmp/spoilt" --out "$tmp/none"
tell 'nothing was put together' test ! -e "$tmp/none"
full() { # a disk that is full when a piece is written
  mkdir -p "$tmp/full" && ln -s /dev/full "$tmp/full/parts" 2> /dev/null
  ends 1 "$randpack" run "$tmp/few.scene" --realizations 0-1 --out "$tmp/full" --set save=false && grep -q 'cannot be written' "$tmp/err"
}
tell 'a piece that cannot be written is a failure' full

# --- as a job array of Slurm has it
array() {
  mkdir "$tmp/array" && cd "$tmp/array" || return 1
  local task script=$OLDPWD/examples/array.sbatch
  for task in 1 2 3; do
    SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_COUNT=3 RANDPACK=$randpack bash "$script" "$tmp/few.scene" 7 || return 1
  done
  MERGE=1 RANDPACK=$randpack bash "$script" "$tmp/few.scene" 7 && cd "$OLDPWD" && tables "$tmp/few" "$tmp/array/results" &&
    cmp "$tmp/few/pack-6.xyz" "$tmp/array/pieces/pack-6.xyz"
}
randpack=$(realpath "$randpack")
tell 'the script for a job array' array
tell 'the scripts are read by the shell' bash -n examples/array.sbatch
tell 'both of them' bash -n examples/mpi.sbatch
copies() { # started as copies that do not know of each other
  ends 2 env OMPI_COMM_WORLD_SIZE=4 OMPI_COMM_WORLD_RANK=0 "$randpack" run "$tmp/few.scene" --out "$tmp/copies" &&
    grep -q 'started as 4 copies, but built without MPI' "$tmp/err" && [ ! -e "$tmp/copies" ] &&
    ends 0 env OMPI_COMM_WORLD_SIZE=4 OMPI_COMM_WORLD_RANK=1 "$randpack" run "$tmp/few.scene" --out "$tmp/copies" &&
    [ ! -s "$tmp/err" ] && [ ! -e "$tmp/copies" ] && ends 0 env SLURM_STEP_NUM_TASKS=2 SLURM_PROCID=1 \
    "$randpack" run "$tmp/few.scene" --realizations 0-2 --out "$tmp/copies" && [ -e "$tmp/copies/parts" ]
}
if nm "$randpack" 2> /dev/null | grep -q MPI_Init; then
  echo 'SKIP: this program has MPI, so copies without it were not started'
else
  tell 'copies without MPI are refused in one line, if they have no pieces' copies
fi

# --- a run that is killed
# It writes a part when two seconds have passed, which it spends asleep here.
say long 'dimension = 3; seed = 8; realizations = 10; save = true; species = ( { name = "A"; radius = 1.0; number = 500; } ); fraction = 0.6;
make = { method = "crm"; growth = 0.02; }; measure = { contact = {}; };'
killed() {
  local pid tries=0
  "$randpack" run "$tmp/long.scene" --threads 1 --out "$tmp/killed" 2> "$tmp/err" &
  pid=$!
  until [ -e "$tmp/killed/pack-0.xyz" ] || [ $((tries += 1)) -gt 3000 ]; do sleep 0.02; done
  kill -STOP $pid && sleep 2.2 && kill -CONT $pid
  until ls "$tmp/killed/parts" 2> /dev/null | grep -qv part || ! kill -0 $pid 2> /dev/null || [ $((tries += 1)) -gt 6000 ]; do sleep 0.02; done
  kill -9 $pid 2> /dev/null || { echo 'it had ended before'; return 1; }
  wait $pid 2> /dev/null
  [ ! -e "$tmp/killed/summary.tsv" ] && touch -d 2001-01-01 "$tmp/killed/pack-0.xyz" &&
    run long killed && run long whole && diff -r "$tmp/whole" "$tmp/killed" && [ "$tmp/killed/pack-0.xyz" -ot "$tmp/long.scene" ]
}
tell 'a run that was killed goes on to the same bytes' killed
short() { ends 0 "$randpack" run "$tmp/few.scene" --out "$tmp/short" && [ ! -e "$tmp/short/parts" ]; }
tell 'a short run writes no parts' short

# --- more kinds of scenes
say counts "$(cat "$tmp/few.scene") sweep = ( { key = \"realizations\"; values = [2, 4]; } );"
tell 'pieces of a sweep over numbers of realizations' pieces counts counts 3,0 1-2
tell 'pieces of a sweep of growth' pieces grown grown 1-2 0
tell 'pieces of families, sampled' pieces shaken shaken 0 1
tell 'pieces of packs from one base, diluted' pieces field field 1 0
exit $failed
