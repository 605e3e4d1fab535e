#!/bin/bash
# tests/check-bytes.sh: the same bytes on any number of threads and any processor, for every scene of
# figures/ with two realizations, and for some that no figure shows. The former run in the two variants that have
# nothing in common, the latter in all. A scene that is long even so has a line
# `# small: --set KEY=VALUE ...` with what makes it short.
. tests/bytes.sh
all=("${variants[@]}") variants=(one old)
small() { same_bytes "$1" "$2" --set realizations=2 $(grep -q '^side' "$1" && echo --set side=20) $(sed -n 's/^# small://p' "$1"); }
for file in figures/*.scene; do
  name=${file##*/}
  tell "the same bytes of ${name%.scene} with ${variants[*]}" small "$file" "${name%.scene}"
done
variants=("${all[@]}")
cat > "$tmp/mixed.scene" <<'END'
dimension = 3; seed = 31; realizations = 5; box = [1.0, 1.3, 0.9]; gap = 0.02; save = true;
species = ( { name = "A"; radius = 1.0; volume = 0.5; }, { name = "B"; radius = 0.6; volume = 0.3; },
            { name = "C"; radius = 0.31; volume = 0.2; } );
number = 700; fraction = 0.27;
make = { method = "rsa"; order = "large first"; };
measure = { rdf = { reach = 4.0; estimator = "central"; }; nearest = {}; order = {};
            histogram = { centre = "random"; windows = 1000; }; coordination = { tolerance = 0.05; }; };
END
cat > "$tmp/discs.scene" <<'END'
dimension = 2; seed = 9007199254740992; realizations = 7; side = 30.0; fraction = "max"; save = true;
species = ( { name = "disc"; radius = 1.0; share = 0.25; }, { name = "dot"; radius = 0.4; share = 0.75; } );
make = { method = "rsa"; };
measure = { rdf = { reach = 9.0; step = 0.1; }; K = {}; approach = {}; order = {}; histogram = {}; };
END
cat > "$tmp/grown.scene" <<'END'
dimension = 3; seed = 5; realizations = 3; save = true; box = [1.0, 1.0, 1.5];
species = ( { name = "A"; radius = 1.0; number = 60; }, { name = "B"; radius = 0.4; number = 200; } ); fraction = 0.5;
make = { method = "crm"; growth = 0.2; mass = "volume"; rest = 4; };
measure = { rdf = { reach = 3.0; }; order = {}; pressure = { warm = 4; blocks = 4; each = 4; }; };
sweep = ( { key = "make.protocol"; values = ("literal", "isothermal"); }, { key = "make.start"; values = ("points", "rsa"); } );
END
cat > "$tmp/shaken.scene" <<'END'
dimension = 3; seed = 6; realizations = 2; save = true; number = 150; fraction = 0.5;
species = ( { name = "A"; radius = 1.0; volume = 0.7; }, { name = "B"; radius = 0.5; volume = 0.3; sizes = { law = "lognormal"; spread = 0.2; }; } );
make = { method = "crm"; growth = 0.2; };
shake = { radius = 0.05; sweeps = 6; samples = 2; apart = 2; };
measure = { partials = { scale = "r"; reach = [3.0]; window = 2.5; }; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "retry", "collision", "collision-longest", "chain", "newton", "dynamics"); } );
END
for name in mixed discs grown shaken; do
  tell "the same bytes of $name with ${variants[*]}" same_bytes "$tmp/$name.scene" $name
done
other_seed() { ends 0 "$randpack" run "$tmp/discs.scene" --set seed=0 --out "$tmp/seed" && ! diff -rq "$tmp/seed" "$tmp/one/discs"; }
tell 'another seed gives other bytes' other_seed > "$tmp/told"
grep -v '^Files' "$tmp/told"
exit $failed
