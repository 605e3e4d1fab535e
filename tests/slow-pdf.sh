#!/bin/bash
# tests/slow-pdf.sh: the same book, byte for byte, from two directories, in another time zone, language
# and number of jobs; and an edit of prose re-weaves it within seconds, computing nothing. The book is the draft, whose
# scenes, figures and prose are the same files; with BOOK=paper it is the whole one, which takes two hours of processor time.
. tests/tell.sh
book=${BOOK:-draft} built=build
[ "$book" = paper ] || built=build/draft/build
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
paper() { # paper DIR [MAKE'S WORDS]: a copy of the tree there, and its book
  local dir=$1
  shift
  mkdir -p "$dir"
  tar cf - --exclude=./build --exclude=./.git . | tar xf - -C "$dir"
  env "${around[@]}" make -C "$dir" "$@" "$book" > "$dir.log" 2>&1 || { tail -20 "$dir.log"; return 1; }
}
around=()
tell 'the book is built' paper "$tmp/a"
around=(TZ=Asia/Tokyo LANG=de_DE.UTF-8 LC_ALL=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 RANDPACK_SIMD=default)
tell 'and built elsewhere, in Tokyo, in German, without wide vectors, by one job' paper "$tmp/another/place/b" -j1
same() { cmp "$tmp/a/build/$book.pdf" "$tmp/another/place/b/build/$book.pdf"; }
tell 'byte for byte the same' same
tables() { diff -rq "$tmp/a/$built/data" "$tmp/another/place/b/$built/data"; }
tell 'and so are its tables' tables
edit() {
  cp "$tmp/a/build/$book.pdf" "$tmp/before.pdf"
  sed -i '0,/^\\section/s//A sentence more, set by a test.\n\n&/' "$tmp/a/src/measuring/order.nw"
  local start=$SECONDS
  make -C "$tmp/a" "$book" > "$tmp/edit.log" 2>&1 || { tail -20 "$tmp/edit.log"; return 1; }
  ! grep -q '^  \(compute\|draw\)' "$tmp/edit.log" && [ $((SECONDS - start)) -lt 60 ] || { cat "$tmp/edit.log"; return 1; }
  ! cmp -s "$tmp/a/build/$book.pdf" "$tmp/before.pdf"
}
tell 'an edit of prose weaves the book again, and neither computes nor draws' edit
again() { make -C "$tmp/a" "$book" > "$tmp/again.log" 2>&1 && ! grep -q '^  ' "$tmp/again.log"; }
tell 'then there is nothing left to do' again
exit $failed
