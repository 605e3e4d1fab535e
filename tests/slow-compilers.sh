#!/bin/bash
# tests/slow-compilers.sh: every maker, shake and measure gives the same bytes when another compiler has built the
# program, and when it was built for another processor, aarch64, which qemu imitates. Only the fingerprint in the
# headers, which knows the compiler, may differ.
. tests/tell.sh
. tests/small.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
small_scenes "$tmp"
names=$(cd "$tmp" && for scene in *.scene; do echo "${scene%.scene}"; done)
run() { ends 0 "$@" run "$tmp/$name.scene" --threads 1 --out "$tmp/$to/$name"; } # run COMMAND...: the scene name, into to
same() { diff -r -q -I ', fingerprint [0-9a-f]*$' "$tmp/here/$name" "$tmp/$to/$name" && [ -s "$tmp/$to/$name/summary.tsv" ]; }
as_here() { run "$@" && same; }
build() { # build NAME WORDS...: into $tmp/NAME
  make B="$tmp/$1" "${@:2}" "$tmp/$1/bin/randpack" > "$tmp/$1.log" 2>&1 || { tail -5 "$tmp/$1.log"; return 1; }
}
to=here
for name in $names; do run "$randpack" || { echo "FAIL: the scene $name"; failed=1; }; done

to=clang
[[ ${CC:-gcc} != *clang* ]] || to=gcc
if echo 'int main(void) { return 0; }' | $to -x c -fopenmp - -lgsl -lfftw3 -lz -lconfig -o "$tmp/tried" 2> "$tmp/err"; then
  tell "$to builds the program" build $to CC=$to
  for name in $names; do tell "the same bytes of $name by $to" as_here "$tmp/$to/bin/randpack"; done
else
  echo "SKIP: no $to with OpenMP, so no bytes were compared with its"
fi

# The libraries for aarch64 are fetched, not installed.
to=aarch64 cross=aarch64-linux-gnu-gcc lib=$tmp/root/usr/lib/aarch64-linux-gnu
qemu=$(command -v qemu-aarch64-static || command -v qemu-aarch64)
libraries() {
  mkdir -p "$tmp"/apt/{lists,archives}/partial && cd "$tmp/apt" &&
    apt=(-q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists="$tmp/apt/lists" -o Dir::Cache="$tmp/apt") &&
    apt-get "${apt[@]}" update && apt-get "${apt[@]}" download libgsl-dev libfftw3-dev zlib1g-dev libconfig-dev &&
    for package in *.deb; do dpkg-deb -x "$package" "$tmp/root" || return 1; done
}
if command -v $cross > "$tmp/out" && [ -n "$qemu" ] && (libraries) > "$tmp/fetched" 2>&1; then
  tell "it builds for $to" build $to CC=$cross LIBS="-static $lib/libconfig.a $lib/libfftw3.a $lib/libz.a $lib/libgsl.a $lib/libgslcblas.a -lm" \
    WARNINGS="-isystem $tmp/root/usr/include"
  for name in $names; do tell "the same bytes of $name on $to" as_here "$qemu" "$tmp/$to/bin/randpack"; done
else
  echo "SKIP: no $cross, no qemu-aarch64-static or no libraries to fetch, so nothing was built for $to"
fi
exit $failed
