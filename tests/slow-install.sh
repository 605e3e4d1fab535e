#!/bin/bash
# tests/slow-install.sh: the library under valgrind without memory; in C++; in threads; with another compiler; and an installation
# into a folder whose name has a blank.
. tests/tell.sh
unset MAKEFLAGS MAKELEVEL MFLAGS MAKEOVERRIDES
dest=$tmp/dest root=$tmp/dest/usr/local cc=${CC:-gcc}
libs='-lgsl -lgslcblas -lz -lm'
makes() { make -s "$@" > "$tmp/made" 2>&1 || { tail -5 "$tmp/made"; return 1; }; }
tell 'make install, where it goes by default' makes install DESTDIR="$dest"
cat > "$tmp/shapes.xyz" <<'END'
2
Lattice="9 0 0 0 9 0 0 0 9" pbc="T T F" Properties=type:S:1:pos:R:3:radius:R:1:angle:R:1 shape_E="superellipse:1.5:2" shape_P="polygon:5"
E 1 1 0 1 0.1
P 5 5 0 1 0.2
END
watched() { # the library's own requests alone fail, so that valgrind can keep its eyes on all others
  # shellcheck disable=SC2086
  "$cc" -std=c11 -g -O1 -DWRAP -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=free tests/memory.c -o "$tmp/memory" \
    -I"$root/include" "$root/lib/librandpack.a" $libs &&
    RANDPACK_SIMD=avx2 valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=all \
      --log-file="$tmp/valgrind" "$tmp/memory" "$tmp/memory.xyz" "$tmp/shapes.xyz" > "$tmp/lack" &&
    [ ! -s "$tmp/valgrind" ] || { head -30 "$tmp/valgrind"; return 1; }
}
if command -v valgrind > "$tmp/out"; then
  tell 'without memory valgrind sees no leak and no touch of what is freed' watched
  grep '^FAIL:' "$tmp/lack" && failed=1
else
  echo 'SKIP: valgrind is not installed, so the library was not run under it'
fi

cat > "$tmp/threads.c" <<'END'
#include <pthread.h>
#include <randpack.h>
#include <stdio.h>
#include <string.h>
static double x[4][600];
static void *grow(void *to) {
  size_t number[] = {200};
  double radius[] = {1}, g[20];
  randpack_outcome out;
  for (int k = 0; k < 5; k++) {
    randpack_pack *pack = randpack_grow(3, 1, number, radius, 0.5, 0.1, 7, &out);
    if (!pack || randpack_g(pack, 2, 0.05, 20, g, &out))
      return to;
    randpack_to_arrays(pack, to, NULL, NULL);
    randpack_free(pack);
    if (randpack_rsa(3, (double[]){5, 5, 5}, 1, number, radius, 0, 1, &out) || out.status != RANDPACK_UNREACHED)
      return to;
  }
  return NULL;
}
int main(void) {
  pthread_t thread[4];
  void *failed;
  int bad = 0;
  for (int t = 0; t < 4; t++)
    pthread_create(&thread[t], NULL, grow, x[t]);
  for (int t = 0; t < 4; t++) {
    pthread_join(thread[t], &failed);
    bad |= failed || memcmp(x[t], x[0], sizeof x[0]) || x[t][0] == 0;
  }
  return bad;
}
END
compiled() { # compiled FILE COMPILER...: against the shared library, and run
  local file=$1
  shift
  "$@" "$file" -o "$tmp/run" -I"$root/include" -L"$root/lib" -lrandpack -pthread && (cd "$tmp" && LD_LIBRARY_PATH=$root/lib ./run > run.out)
}
tell 'four threads make the same pack, undisturbed' compiled "$tmp/threads.c" "$cc" -std=c11 -Wall -Werror
raced() { LD_LIBRARY_PATH=$root/lib valgrind -q --tool=helgrind --error-exitcode=99 "$tmp/run" 2> "$tmp/err" || { head -20 "$tmp/err"; return 1; }; }
if command -v valgrind > "$tmp/out"; then tell 'and valgrind sees no race' env RANDPACK_SIMD=avx2 bash -c "$(declare -f raced); root='$root' tmp='$tmp'; raced"; fi
sed 's/for (int k/for (size_t k/' examples/curve.c > "$tmp/curve.cc"
if command -v g++ > "$tmp/out"; then tell 'a program in C++ is compiled and runs' compiled "$tmp/curve.cc" g++ -Wall -Wextra -Wpedantic -Werror
else echo 'SKIP: g++ is not installed, so no program in C++ was compiled'; fi
if command -v clang > "$tmp/out"; then tell 'the header is good for clang, with every warning' compiled examples/curve.c clang -Weverything -Wno-padded -Wno-declaration-after-statement -Wno-poison-system-directories -Werror
else echo 'SKIP: clang is not installed, so it compiled nothing'; fi

spaced=$tmp/'a folder'
tell 'make install into a folder with a blank in its name' makes install DESTDIR="$spaced" PREFIX=/usr
tell 'the program there' ends 0 "$spaced/usr/bin/randpack" --version
tell 'make uninstall' makes uninstall DESTDIR="$spaced" PREFIX=/usr
empty() { ! find "$1" ! -type d | grep .; }
tell 'leaves nothing there' empty "$spaced"
makes uninstall DESTDIR="$dest" || failed=1
tell 'nor where it goes by default' empty "$dest"
exit $failed
