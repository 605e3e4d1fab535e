#!/bin/bash
# tests/slow-kill.sh: runs of some ten seconds, each killed at twenty random moments and taken up every time, end with the bytes of the
# run that nobody disturbed: growth and flight, growth to jamming, and growth with shakes on the way and after it.
. tests/kills.sh
cat > "$tmp/grown.scene" <<'END'
dimension = 3; seed = 3; realizations = 4; save = true; fraction = 0.63;
species = ( { name = "A"; radius = 1.0; number = 1500; }, { name = "B"; radius = 0.7; number = 500; } );
make = { method = "crm"; growth = 0.02; rest = 50; };
measure = { rdf = { reach = 3.0; }; pressure = {}; };
END
cat > "$tmp/jammed.scene" <<'END'
dimension = 3; seed = 5; realizations = 2; save = true; fraction = "max";
species = ( { name = "A"; radius = 1.0; number = 300; } );
make = { method = "crm"; growth = 0.2; };
measure = { rdf = { reach = 3.0; }; order = {}; };
END
cat > "$tmp/shaken.scene" <<'END'
dimension = 2; seed = 4; realizations = 2; save = true; fraction = 0.68;
species = ( { name = "A"; radius = 1.0; number = 900; } );
make = { method = "crm"; growth = 0.02; };
shake = { radius = 0.1; tries = 5; sweeps = 800; every = 20.0; each = 5; marks = [0, 200]; samples = 3; apart = 200; };
measure = { rdf = { reach = 3.0; }; order = {}; pressure = {}; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "retry", "collision", "chain", "newton"); } );
END
twenty() { # twenty THREADS SCENE
  local name=$2-$1 kills=0 rounds=0 TIMEFORMAT=%R took
  took=$( { time "$randpack" run "$tmp/$2.scene" --out "$tmp/$2-t" --threads "$1" --checkpoint 0; } 2>&1)
  # a run that dies after a twentieth of its time, twenty times, would be done; what is lost on the way lengthens it
  while [ $kills -lt 20 ] && [ $rounds -lt 200 ]; do
    killed "$(randomly 0.01 "$(awk -v t="$took" 'BEGIN { print t / 8 }')")" "$name" --threads "$1" --checkpoint 0.1 && kills=$((kills + 1)) ||
      rm -rf "${tmp:?}/$name"
    rounds=$((rounds + 1))
  done
  begin "$name" --threads "$1" --checkpoint 0.1
  ended
  echo "$2 on $1 threads: $took s, $kills kills" >&2
  [ $status = 0 ] && [ $kills = 20 ] && whole "$name"
}
for scene in grown jammed shaken; do
  ends 0 "$randpack" run "$tmp/$scene.scene" --out "$tmp/$scene" --checkpoint 0 || failed=1
  for threads in 1 2; do
    tell "$scene on $threads threads, killed twenty times: the same bytes" twenty $threads $scene
  done
done
exit $failed
