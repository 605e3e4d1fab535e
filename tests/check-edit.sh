#!/bin/bash
# tests/check-edit.sh: an edit re-runs what depends on it, and nothing else. In a copy of the tree with
# two small scenes, of which one measures order. What depends on what is the same without optimisation.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
copy=$tmp/copy
mkdir "$copy" && tar cf - --exclude=./build --exclude=./.git --exclude='*.scene' . | tar xf - -C "$copy" && cd "$copy" || exit 1
sed -i 's/^CFLAGS  *:= -O3 -g1/CFLAGS := -O0/' Makefile && grep -q '^CFLAGS := -O0' Makefile || exit 1
cat > figures/rsa/pairs.scene <<'END'
dimension = 2; species = ( { radius = 1.0; number = 60; } ); fraction = 0.3;
make = { method = "rsa"; }; measure = { rdf = { reach = 4.0; }; };
END
cat > figures/rsa/bonds.scene <<'END'
dimension = 3;
species = ( { radius = 1.0; } );
make = { method = "lattice"; lattice = "fcc"; n_l = 1; };
measure = { order = {}; };
END

# runs SCENE...: `make data` computes these scenes and no others.
runs() {
  make data > "$tmp/log" 2>&1 || { tail -5 "$tmp/log"; return 1; }
  sed -n 's/^  compute //p' "$tmp/log" | sort | diff <(for s in "$@"; do echo "$s"; done | sort) -
}
tell 'from clean, every scene is computed' runs bonds pairs
tell 'again, none' runs
sed -i '0,/^\\section/s//A sentence more, and $1+1=2.\n\n&/' src/measuring/order.nw
tell 'an edit of prose computes nothing' runs
grep -q '^/\*' <(notangle -R'[[order.c]]' src/measuring/order.nw) # there are comments in it
sed -i '0,/^<<\[\[order\.c\]\]>>=$/s||&\n/* A comment more. */|' src/measuring/order.nw
tell 'an edit of a comment in the code computes nothing' runs
sed -i 's/W("Q6 and the solid fraction")/W("Q6, and how much is solid")/; s/the longest bond in diameters/the longest of the bonds in diameters/' src/measuring/order.nw
tell 'an edit of a word of help computes nothing' runs
printf '\n<<[[order.c]]>>=\n\nint order_more(int n);\nint order_more(int n) {\n  return n + 1;\n}\n@\n' >> src/measuring/order.nw
tell 'an edit of the code of order computes the scene that measures order' runs bonds
sed -i 's/number = 60/number = 61/' figures/rsa/pairs.scene
tell 'an edit of a scene computes that scene' runs pairs
echo '# A remark.' >> figures/rsa/pairs.scene
tell 'a remark in a scene computes nothing' runs
sed -i 's/random packs of hard/random packs of very hard/' src/scenes/randpack.nw
tell 'an edit of main computes nothing' runs
touch src.nw src/*/*.nw figures/*/*
tell 'new dates of all files compute nothing' runs
rm build/data/bonds/summary.tsv
tell 'a table that is gone is computed again' runs bonds

# A new entry is one chapter and one line: of those to copy, a measure and a maker.
add() { # add KIND LIST NAME: the chapter of tests/entry, and its name in the list of entries
  cp "tests/entry/$3.nw" src/measuring/ && sed -i "s/^%chapter measuring\/order$/&\n%chapter measuring\/$3/" src.nw &&
    sed -i "s/^#define $2(X) /&X($3) /" src/scenes/entries.nw && grep -q "X($3)" src/scenes/entries.nw
}
tell 'a measure is added' add measure MEASURES gap
cat > figures/rsa/gaps.scene <<'END'
dimension = 3; species = ( { radius = 1.5; number = 40; } ); fraction = 0.2; realizations = 2;
make = { method = "rsa"; }; measure = { gap = { unit = 0.5; }; nearest = {}; };
END
tell 'and computes the scene that asks for it, and no other' runs gaps
told() { awk -F'\t' -v q="$1" '$1 == q { print $2 }' "${2:-build/data/gaps}/summary.tsv"; }
tell 'its row is twice the mean gap' awk -v g="$(told mean_gap)" -v n="$(told nearest)" 'BEGIN { exit (g / 2 - n + 2) ^ 2 > 1e-18 }'
r=build/bin/randpack
helped() { "$r" help measure.gap > "$tmp/out" && grep -q 'measure.gap.unit .*; default 1$' "$tmp/out" && grep -q 'row mean_gap: to the nearest' "$tmp/out"; }
tell 'help knows it' helped
planned() { "$r" plan figures/rsa/gaps.scene > "$tmp/out" && grep -q '^measure.* gap' "$tmp/out" && grep -q '^modules.* gap_entry' "$tmp/out"; }
tell 'plan knows it' planned
wrong() { sed 's/unit =/untis =/' figures/rsa/gaps.scene > "$tmp/wrong.scene" && refused ':2: untis is not a key of measure.gap; known here: unit' "$r" run "$tmp/wrong.scene"; }
tell 'a wrong key of it is answered' wrong
tell 'and a pack that it is not of' refused 'gap needs hard particles; leave it out' "$r" plan figures/rsa/gaps.scene --set make.method=points
swept() { ends 0 "$r" run figures/rsa/gaps.scene --set 'sweep=({key="measure.gap.unit";values=[1.0,2.0];})' --out "$tmp/swept" &&
  awk -F'\t' '$1 == "mean_gap@1" { a = $2 } $1 == "mean_gap@2" { b = $2 } END { exit !(a > 0 && (a - 2 * b) ^ 2 < 1e-18) }' "$tmp/swept/summary.tsv"; }
tell 'it can be swept' swept
shaken() { ends 0 "$r" run figures/rsa/gaps.scene --set 'shake={sweeps=5;radius=0.5;}' --set save=true --out "$tmp/shaken" &&
  [ -n "$(told made.mean_gap "$tmp/shaken")" ] && [ -n "$(told shaken.mean_gap "$tmp/shaken")" ] && [ -n "$(told change.mean_gap "$tmp/shaken")" ]; }
tell 'and told before and after shaking' shaken
foreign() { ends 0 "$r" measure "$tmp"/shaken/pack-{0,1}.xyz --scene figures/rsa/gaps.scene --out "$tmp/foreign" &&
  [ "$(told mean_gap "$tmp/foreign")" = "$(told shaken.mean_gap "$tmp/shaken")" ]; }
tell 'and measured of packs from files' foreign
tell 'a maker is added' add maker MAKERS pair
cat > figures/rsa/two.scene <<'END'
dimension = 3; species = ( { radius = 1.0; number = 2; } ); fraction = 0.001;
make = { method = "pair"; distance = 2.75; }; measure = { gap = {}; };
END
tell 'and computes the scene that asks for it, and no other' runs two
tell 'its particles are so far apart' awk -v g="$(told mean_gap build/data/two)" 'BEGIN { exit (g - 0.75) ^ 2 > 1e-20 }'
exit $failed
