#!/bin/bash
# tests/check-edit.sh: an edit re-runs what depends on it, and nothing else. In a copy of the tree with
# two small scenes, of which one measures order. What depends on what is the same without optimisation.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
copy=$tmp/copy
mkdir "$copy" && tar cf - --exclude=./build --exclude=./.git --exclude='*.scene' . | tar xf - -C "$copy" && cd "$copy" || exit 1
sed -i 's/^CFLAGS  *:= -O3 -g1/CFLAGS := -O0/' Makefile && grep -q '^CFLAGS := -O0' Makefile || exit 1
cat > figures/pairs.scene <<'END'
dimension = 2; species = ( { radius = 1.0; number = 60; } ); fraction = 0.3;
make = { method = "rsa"; }; measure = { rdf = { reach = 4.0; }; };
END
cat > figures/bonds.scene <<'END'
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
sed -i '0,/^\\section/s//A sentence more, and $1+1=2.\n\n&/' src/order.nw
tell 'an edit of prose computes nothing' runs
grep -q '^/\*' <(notangle -R'[[order.c]]' src/order.nw) # there are comments in it
sed -i '0,/^<<\[\[order\.c\]\]>>=$/s||&\n/* A comment more. */|' src/order.nw
tell 'an edit of a comment in the code computes nothing' runs
printf '\n<<[[order.c]]>>=\n\nint order_more(int n);\nint order_more(int n) {\n  return n + 1;\n}\n@\n' >> src/order.nw
tell 'an edit of the code of order computes the scene that measures order' runs bonds
sed -i 's/number = 60/number = 61/' figures/pairs.scene
tell 'an edit of a scene computes that scene' runs pairs
echo '# A remark.' >> figures/pairs.scene
tell 'a remark in a scene computes nothing' runs
sed -i 's/random packs of hard/random packs of very hard/' src.nw
tell 'an edit of main computes nothing' runs
touch src.nw src/*.nw figures/*
tell 'new dates of all files compute nothing' runs
rm build/data/bonds/summary.tsv
tell 'a table that is gone is computed again' runs bonds
exit $failed
