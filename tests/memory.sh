# shellcheck shell=bash
# tests/memory.sh: sourced by slow-memory.sh (unit tests) and slow-traced.sh (makers and measures): under valgrind none of them decides by a byte
# that nobody has set, or touches memory that is not its own. A bare number that differs is no failure here: valgrind's long double is short.
. tests/tell.sh
command -v valgrind > "$tmp/found" || { echo 'SKIP: valgrind is not installed, so nothing was run under it'; exit; }
export RANDPACK_SIMD=avx2 OMP_NUM_THREADS=1 RANDPACK_MEMORY=1
clean() { # clean NAME FILE COMMAND...: the command leaves the file, whatever it finds itself, and valgrind finds nothing
  local name=$1 file=$2
  shift 2
  valgrind -q --error-exitcode=99 --log-file="$tmp/$name.valgrind" "$@" > "$tmp/$name.log" 2>&1 < /dev/null
  [ -s "$file" ] && [ ! -s "$tmp/$name.valgrind" ] || { head -30 "$tmp/$name.valgrind"; tail -3 "$tmp/$name.log"; return 1; }
}
