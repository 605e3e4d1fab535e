#!/bin/bash
# tests/check-install.sh: make install puts the program, its page, its completion and the library where they belong, and make
# uninstall leaves nothing; the library shows its header's functions only, the examples run with it, and no lack of memory ends it.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
cc=${CC:-gcc} dest=$tmp/dest prefix=/opt/randpack root=$tmp/dest/opt/randpack
placed='bin/randpack include/randpack.h lib/librandpack.a lib/librandpack.so lib/librandpack.so.0 lib/librandpack.so.VERSION
  lib/pkgconfig/randpack.pc share/bash-completion/completions/randpack share/doc/randpack/CHANGES share/doc/randpack/CITATION.cff
  share/doc/randpack/LICENSE share/doc/randpack/README.md share/doc/randpack/examples/beads.scene share/doc/randpack/examples/centres.txt
  share/doc/randpack/examples/concrete.scene share/doc/randpack/examples/curve.c share/doc/randpack/examples/propellant.scene
  share/doc/randpack/examples/tomography.scene share/doc/randpack/examples/first.scene share/doc/randpack/examples/make.c share/doc/randpack/examples/measure.c
  share/man/man1/randpack.1'
version=$("$randpack" --version) version=${version#randpack }

makes() { make -s "$@" DESTDIR="$dest" PREFIX=$prefix > "$tmp/made" 2>&1 || { tail -5 "$tmp/made"; return 1; }; }
listed() { # the files, and the book if it was woven
  (cd "$root" && find . ! -type d | sed 's|^\./||; s/so\.'"$version"'$/so.VERSION/' | grep -v 'paper.pdf$' | LC_ALL=C sort) |
    diff <(tr -s ' \n' '\n' <<< "$placed" | grep . | LC_ALL=C sort) -
}
book() { # it is there, or a line says that it is not
  if [ -e build/paper.pdf ]; then cmp build/paper.pdf "$root/share/doc/randpack/paper.pdf"
  else grep -q 'without the book: .*make paper' "$tmp/made"; fi
}
tell 'make install' makes install
tell 'each file in its place, and no other' listed
tell 'the book, or a word about it' book
tell 'the program that was installed runs' ends 0 "$root/bin/randpack" --version

# --- the page and the completion
names=$("$randpack" help | sed -n 's/^  \(\(make\|shake\|measure\|theory\)\.[A-Za-z0-9_-]*\): .*/\1/p')
page() { # each entry has its part, with its keys
  local name
  [ "$(wc -w <<< "$names")" -gt 40 ] && for name in $names; do grep -qx "\.SS $name" "$root/share/man/man1/randpack.1" || { echo "$name"; return 1; }; done &&
    grep -q '^  make\.pressure ' "$root/share/man/man1/randpack.1" && grep -q '^\.SH EXIT STATUS' "$root/share/man/man1/randpack.1"
}
formats() { groff -man -Tutf8 -ww "$root/share/man/man1/randpack.1" > "$tmp/page" 2> "$tmp/err" && [ ! -s "$tmp/err" ] || { head -3 "$tmp/err"; return 1; }; }
tell 'the page of the manual has every entry' page
if command -v groff > "$tmp/out"; then tell 'and is good roff' formats; else echo 'SKIP: groff is not installed, so the page was not formatted'; fi
completes() { # completes 'WORDS' EXPECTED...: the last word may become each of these
  local given words
  given=$1
  shift
  words=$(bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _randpack; printf "%s\n" "${COMPREPLY[@]}"' - \
    "$root/share/bash-completion/completions/randpack" $given "$last") || return 1
  diff <(printf '%s\n' "$@" | sort) <(sort <<< "$words")
}
last=m tell 'a verb is completed' completes randpack measure merge
last=--t tell 'an option' completes 'randpack run x.scene' --threads --time
last=measure.rd tell 'an entry' completes 'randpack help' measure.rdf
last= tell 'every entry, and none but the entries' completes 'randpack help' $names
last=py tell 'a curve' completes 'randpack theory' py
last=examples/first tell 'a file' completes 'randpack run' examples/first.scene

# --- the library
symbols() { nm "$@" | awk '$2 ~ /[A-TV-Z]/ && $NF != "RANDPACK_0" { print $NF }' | sed 's/@.*//' | LC_ALL=C sort -u; }
header() { grep -oE '\brandpack_[a-zA-Z0-9_]+\(' "$root/include/randpack.h" | tr -d '(' | LC_ALL=C sort -u; }
shown() { [ "$(header | wc -l)" -gt 20 ] && diff <(header) <(symbols "$@"); }
tell 'the shared library shows the functions of the header' shown -D --defined-only "$root/lib/librandpack.so"
tell 'the static one, too' shown --defined-only -g "$root/lib/librandpack.a"
quiet() { # nothing that prints or ends a program, no threads, no allocation by others; an assertion would be an error of ours
  ! nm -u "$root/lib/librandpack.a" | awk '{ print $NF }' |
    grep -E '^(exit|_exit|abort|stderr|stdout|printf|puts|putchar|perror|GOMP.*|omp.*|fftw.*|gsl_.*alloc|gsl_set_error.*)$'
}
tell 'nothing in it ends a program or prints' quiet
constant() { ! objdump -h "$root/lib/librandpack.a" | awk '$2 ~ /^[.](data|bss)/ && $2 !~ /^[.]data[.]rel[.]ro/ && $3 !~ /^0+$/' | grep .; }
tell 'no variable of it is shared by threads' constant
named() { readelf -d "$root/lib/librandpack.so" | grep -q 'SONAME.*\[librandpack.so.0\]' && [ "$(readlink "$root/lib/librandpack.so.0")" = "librandpack.so.$version" ]; }
tell 'its name is that of its version' named
tell 'the header says the version' grep -qx "#define RANDPACK_VERSION \"$version\"" "$root/include/randpack.h"

# Compiled as the documentation says.
export PKG_CONFIG_PATH=$root/lib/pkgconfig PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1
flags() { pkg-config --define-variable=prefix="$root" "$@" randpack; }
compile() { # compile NAME WORDS...: an example, or a test
  # shellcheck disable=SC2046
  "$cc" -std=c11 -Wall -Wextra -Wpedantic -Werror "$1" -o "$tmp/$(basename "$1" .c)" $(flags --cflags) "${@:2}"
}
run() { (cd "$tmp" && LD_LIBRARY_PATH=$root/lib "./$1" > "$1.out") && diff "$tmp/$1.out" -; }
if command -v pkg-config > "$tmp/out"; then
  for example in make measure curve; do
    # shellcheck disable=SC2046
    tell "the example $example is compiled" compile examples/$example.c $(flags --libs)
  done
  tell 'a pack is made' run make <<< 'fraction 0.580000, no overlap: 1'
  # 6 of the 26 others at contact, 12 at the square root of 8, in the volume 216.
  tell 'a pack in arrays is measured' run measure <<< '27 particles with 6 neighbours, 6.0 in the mean
2.125 3.509646
2.375 0.000000
2.625 0.000000
2.875 3.836741'
  first() { (cd "$tmp" && LD_LIBRARY_PATH=$root/lib ./curve | sed -n '1p;17p') | diff - <(printf '2.000 7.128027682\n4.000 1.555057832\n'); }
  tell "Percus and Yevick's curve" first
  echo 'dimension = 3; measure = { nearest = {}; };' > "$tmp/measured.scene"
  measured() { ends 0 "$randpack" measure "$tmp/pack.xyz" --scene "$tmp/measured.scene" --out "$tmp/of" && awk -v f="$(value fraction "$tmp/of")" 'BEGIN { exit !((f - 0.58) ^ 2 < 1e-24) }'; }
  tell 'the pack that it wrote has the fraction' measured
else
  echo 'SKIP: pkg-config is not installed, so the examples were not compiled'
fi
lines() { ! awk 'FNR == 30 { print FILENAME }' examples/*.c | grep .; }
tell 'the examples have less than thirty lines' lines

# The same pack as the scene that says the same.
cat > "$tmp/same.scene" <<'END'
dimension = 3; seed = 2012; fraction = 0.58; save = true;
species = ( { name = "0"; radius = 1.0; number = 150; }, { name = "1"; radius = 1.5; number = 50; } );
make = { method = "crm"; growth = 0.05; };
END
same() { ends 0 "$randpack" run "$tmp/same.scene" --out "$tmp/scene" && diff <(tail -n +3 "$tmp/scene/pack-0.xyz") <(tail -n +3 "$tmp/pack.xyz"); }
[ ! -e "$tmp/pack.xyz" ] || tell 'a scene makes the same pack, to the last bit' same

# --- without memory
cat > "$tmp/shapes.xyz" <<'END'
2
Lattice="9 0 0 0 9 0 0 0 9" pbc="T T F" Properties=type:S:1:pos:R:3:radius:R:1:angle:R:1 shape_E="superellipse:1.5:2" shape_P="polygon:5"
E 1 1 0 1 0.1
P 5 5 0 1 0.2
END
lacking() { # lacking WORDS...: compiled with these, all its lines tell PASS; they are passed on
  # shellcheck disable=SC2046
  "$cc" -std=c11 -O1 tests/memory.c -o "$tmp/memory" -I"$root/include" "$@" "$root/lib/librandpack.a" -lgsl -lgslcblas -lz -lm &&
    "$tmp/memory" "$tmp/memory.xyz" "$tmp/shapes.xyz" > "$tmp/lack"
}
tell 'without the first, the second, ... request there is an outcome, and all is freed' lacking
grep '^\(PASS\|FAIL\):' "$tmp/lack"
! grep -q '^FAIL:' "$tmp/lack" || failed=1

# --- all of it goes
tell 'make uninstall' makes uninstall
gone() { ! find "$dest" ! -type d | grep . && ! find "$dest" -name '*randpack*' | grep -vx "$root" | grep .; }
tell 'leaves nothing' gone

# --- the tarball
dist() { make -s dist > "$tmp/made" 2>&1 && cp "build/randpack-$version.tar.gz" "$tmp/first.tar.gz"; }
again() { # made from itself, in another folder and under another mask, it is the same
  mkdir "$tmp/tree" && tar xf "$tmp/first.tar.gz" -C "$tmp/tree" && cd "$tmp/tree/randpack-$version" &&
    (umask 077 && find . -name '*.nw' -exec touch {} + && make -s dist) > "$tmp/made" 2>&1 && cmp "build/randpack-$version.tar.gz" "$tmp/first.tar.gz"
}
tell 'make dist' dist
tell 'the tarball makes itself, byte for byte' again
exit $failed
