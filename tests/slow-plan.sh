#!/bin/bash
# tests/slow-plan.sh: what plan --time foretells is what a run takes, within a factor of two: seconds of the processor, memory, disk.
. tests/tell.sh
# alone: probes are short, and other work may double one of them; so each scene also has three tries.
"${CC:-gcc}" -O1 -std=c11 tests/usage.c -o "$tmp/usage" || exit 1
say() { printf '%s\n' "$2" > "$tmp/$1.scene"; }
say grown 'dimension = 3; realizations = 2; save = true; species = ( { name = "A"; radius = 1.0; number = 16000; } ); fraction = 0.6;
make = { method = "crm"; growth = 0.05; }; measure = { rdf = { reach = 6.0; }; contact = {}; };'
say saturated 'dimension = 3; realizations = 2; side = 140.0; fraction = "max"; species = ( { radius = 1.0; } );
make = { method = "rsa"; }; measure = { rdf = { reach = 8.0; }; approach = {}; };'
say finite 'dimension = 3; realizations = 2; save = true; species = ( { radius = 1.0; number = 60000; } );
make = { method = "gravity"; }; measure = { rdf = { reach = 6.0; }; coordination = {}; };'
say relaxed 'dimension = 2; realizations = 2; fraction = 0.8; species = ( { radius = 1.0; number = 30000; shape = { kind = "polygon"; sides = 5; }; } );
make = { method = "relax"; }; measure = { order = {}; };'
say lattice 'dimension = 3; species = ( { radius = 1.0; } ); make = { method = "lattice"; lattice = "fcc"; n_l = 25; };
measure = { rdf = { reach = 12.0; }; };'
say shaken 'dimension = 3; realizations = 2; number = 12000; fraction = 0.5; species = ( { radius = 1.0; share = 0.5; }, { radius = 0.7; share = 0.5; } );
make = { method = "crm"; growth = 0.2; }; shake = { radius = 0.05; sweeps = 100; }; measure = { partials = { reach = [4.0]; }; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "chain"); } );'
say pores 'dimension = 3; realizations = 2; number = 500000; fraction = 0.3; species = ( { radius = 1.0; share = 1.0; } );
make = { method = "points"; }; measure = { histogram = { windows = 20000; }; nearest = {}; };'
bytes() { awk -v x="$1" -v unit="$2" 'BEGIN { f["bytes"] = 1; f["kB"] = 1e3; f["MB"] = 1e6; f["GB"] = 1e9; print x * f[unit] }'; }
near() { # near WHAT FORETOLD MEASURED
  awk -v a="$2" -v b="$3" -v what="$1" 'BEGIN { printf "%s: foretold %.3g, measured %.3g, ratio %.2f\n", what, a, b, a / b; exit !(a / b > 0.5 && a / b < 2) }'
}
try() { # foretold, and held to a run on one thread
  local name=$1 status=0 time memory disk unit took
  rm -rf "${tmp:?}/$name"
  ends 0 "$randpack" plan "$tmp/$name.scene" --time --threads 1 || return 1
  time=$(sed -n 's/^time.*: \([^ ]*\) s of the processor.*/\1/p' "$tmp/out")
  read -r memory unit < <(sed -n 's/^memory\t//p' "$tmp/out") && memory=$(bytes "$memory" "$unit")
  read -r disk unit < <(sed -n 's/^disk\t\([^;]*\);.*/\1/p' "$tmp/out") && disk=$(bytes "$disk" "$unit")
  took=$("$tmp/usage" "$randpack" run "$tmp/$name.scene" --threads 1 --out "$tmp/$name") || return 1
  read -r seconds _ most <<< "$took"
  near "$name, seconds" "$time" "$seconds" || status=1
  near "$name, memory" "$memory" "$most" || status=1
  near "$name, disk" "$disk" "$(du -s -B1 "$tmp/$name" | cut -f1)" || status=1
  return $status
}
foretold() { try "$1" || try "$1" || try "$1"; }
for name in grown saturated finite relaxed lattice shaken pores; do
  tell "what $name costs is foretold within a factor of two" foretold $name
done
cheap() { # without --time nothing is probed, and the first lines are the same
  "$randpack" plan "$tmp/grown.scene" > "$tmp/plain" && "$randpack" plan "$tmp/grown.scene" --time > "$tmp/timed" &&
    cmp "$tmp/plain" <(head -n "$(wc -l < "$tmp/plain")" "$tmp/timed") && ! grep -q '^time' "$tmp/plain"
}
tell 'plan without --time says the same, and no time' cheap
tell 'nothing is left of the probes' test -z "$(ls -d /tmp/randpack-plan-* 2> /dev/null)"
exit $failed
