#!/bin/bash
# tests/slow-kill.sh: runs of some ten seconds, each killed at twenty random moments and taken up every time, end with the bytes of the
# run that nobody disturbed: growth and flight, growth to jamming, growth with shakes on the way and after it, gravity with coarse
# particles and dilution, and shapes that are relaxed and shaken.
. tests/kills.sh
cat > "$tmp/grown.scene" <<'END'
dimension = 3; seed = 3; realizations = 4; save = true; fraction = 0.63;
species = ( { name = "A"; radius = 1.0; number = 1500; }, { name = "B"; radius = 0.7; number = 500; } );
make = { method = "crm"; growth = 0.02; rest = 50; };
measure = { rdf = { reach = 3.0; }; pressure = {}; };
END
cat > "$tmp/jammed.scene" <<'END'
dimension = 3; seed = 5; realizations = 2; save = true; fraction = "max";
species = ( { name = "A"; radius = 1.0; number = 80; } );
make = { method = "crm"; growth = 0.2; };
measure = { rdf = { reach = 3.0; }; order = {}; };
END
cat > "$tmp/shaken.scene" <<'END'
dimension = 2; seed = 4; realizations = 2; save = true; fraction = 0.68;
species = ( { name = "A"; radius = 1.0; number = 900; } );
make = { method = "crm"; growth = 0.02; };
shake = { radius = 0.1; tries = 5; sweeps = 800; every = 20.0; each = 5; marks = [10, 200]; samples = 3; apart = 200; };
measure = { rdf = { reach = 3.0; }; order = {}; pressure = {}; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "retry", "collision", "chain", "newton"); } );
END
cat > "$tmp/heap.scene" <<'END'
dimension = 3; seed = 6; realizations = 2; save = true; fraction = 0.4;
species = ( { name = "fine"; radius = 1.0; number = 20000; }, { name = "coarse"; radius = 4.0; number = 20; } );
make = { method = "gravity"; };
dilute = {};
measure = { rdf = { reach = 3.0; }; };
END
cat > "$tmp/shapes.scene" <<'END'
dimension = 2; seed = 7; realizations = 2; save = true; fraction = 0.8;
species = ( { name = "P"; radius = 1.0; number = 2500; shape = { kind = "polygon"; sides = 5; }; } );
make = { method = "relax"; };
shake = { rule = "turning"; radius = 0.1; sweeps = 6000; };
measure = { order = {}; };
END
twenty() { # twenty SCENE THREADS: a run that loses so little each time comes on, and what is lost lengthens it
  local name=$1-$2 seconds
  seconds=$(took "$1" "$2")
  killed 20 "$(awk -v s="$seconds" 'BEGIN { print s / 8 }')" "$name" --threads "$2" --checkpoint 0.1 || return 1
  begin "$name" --threads "$2" --checkpoint 0.1
  ended
  echo "$1 on $2 threads: $seconds s" >&2
  [ $status = 0 ] && whole "$name"
}
for scene in grown jammed shaken heap shapes; do
  took $scene 2 > "$tmp/told"
  for threads in 1 2; do
    tell "$scene on $threads threads, killed twenty times: the same bytes" twenty $scene $threads
  done
done
exit $failed
