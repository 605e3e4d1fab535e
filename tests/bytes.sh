# tests/bytes.sh SETTING...: sourced by check-bytes.sh (small) and slow-bytes.sh (the scenes as they are).
# The same scene and seed give the same bytes: on one thread and on two, at every width of vectors,
# and without the processor's newer instructions.
. tests/tell.sh

# variant NAME: the environment and the threads of a run.
variant() {
  case $1 in
    one) threads=1 given=() ;;
    two) threads=2 given=() ;;
    plain) threads=1 given=(RANDPACK_SIMD=default) ;;
    old) threads=2 given=(GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-AVX512F RANDPACK_SIMD=default) ;;
    *) threads=1 given=(RANDPACK_SIMD="$1") ;;
  esac
}
same_bytes() { # same_bytes SCENE NAME SETTINGS...: run it in every variant, and compare with the first
  local file=$1 name=$2 v threads given
  shift 2
  for v in "${variants[@]}"; do
    variant "$v"
    ends 0 env "${given[@]}" "$randpack" run "$file" --threads $threads --out "$tmp/$v/$name" "$@" || return 1
    [ "$v" = one ] || diff -rq "$tmp/one/$name" "$tmp/$v/$name" || { echo "differs: $v"; return 1; }
  done
  [ -s "$tmp/one/$name/summary.tsv" ]
}
variants=(one two plain old)
for width in avx2 avx512f; do
  ! RANDPACK_SIMD=$width "$randpack" --version > /dev/null 2>&1 || variants+=($width)
done
