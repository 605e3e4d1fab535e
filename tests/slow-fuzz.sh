#!/bin/bash
# tests/slow-fuzz.sh [SECONDS]: libFuzzer gives the readers of packs whatever it can think of, from the files of tests/fuzz,
# under the address and undefined sanitizers, and tests/fuzz.c judges what they make of it. A minute, if nothing else is said.
. tests/tell.sh
seconds=${1:-60} clang=
for c in clang clang-14; do command -v $c > "$tmp/found" && clang=$c; done
echo 'int LLVMFuzzerTestOneInput(const char *, long); int LLVMFuzzerTestOneInput(const char *d, long n) { (void)d; return n < 0; }' > "$tmp/try.c"
[ -n "$clang" ] && $clang -fsanitize=fuzzer,address,undefined "$tmp/try.c" -o "$tmp/try" 2> "$tmp/err" ||
  { echo 'SKIP: no clang with libFuzzer (clang, libclang-rt-14-dev), so no reader was fuzzed'; exit; }
ground=$(for f in src/ground/*.nw; do f=build/plain/$(basename "$f" .nw).c; [ -e "$f" ] && echo "$f"; done)
build() { # shellcheck disable=SC2086
  $clang -std=c11 -D_POSIX_C_SOURCE=200809L -w -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -Ibuild/c -Itests \
    tests/fuzz.c $ground -lz -lgsl -lgslcblas -lm -o "$tmp/fuzz" 2> "$tmp/err" || { head -5 "$tmp/err"; return 1; }
}
tell 'the fuzzer is built' build
mkdir "$tmp/corpus"
survive() {
  "$tmp/fuzz" -max_total_time="$seconds" -max_len=4096 -malloc_limit_mb=100 -rss_limit_mb=2000 -timeout=10 -seed=1 -dict=tests/fuzz/words \
    -artifact_prefix="$tmp/" -print_final_stats=1 "$tmp/corpus" tests/fuzz > "$tmp/log" 2>&1 && return
  grep -v '^#' "$tmp/log" | head -40
  for f in "$tmp"/{crash,oom,timeout,leak}-*; do [ -e "$f" ] && base64 -w 0 "$f" | cut -c1-4000 && echo && cp "$f" build/; done
  return 1
}
tell "whatever bytes a file has, for $seconds s" survive
grep -o 'stat::number_of_executed_units: [0-9]*' "$tmp/log"
exit $failed
