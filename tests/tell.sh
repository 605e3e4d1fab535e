# tests/tell.sh: what the shell tests share; each sources it from the root of the tree.
# shellcheck shell=bash
set -u
unset RANDPACK_SIMD GLIBC_TUNABLES
randpack=${RANDPACK:-$PWD/build/bin/randpack}
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
failed=0

# tell WORDS COMMAND...: PASS if the command ends with 0, else FAIL.
tell() {
  local words=$1
  shift
  if "$@"; then echo "PASS: $words"; else echo "FAIL: $words"; failed=1; fi
}

# ends STATUS COMMAND...: does it end so? Its output is left in $tmp/out and $tmp/err.
ends() {
  local want=$1 status=0
  shift
  "$@" > "$tmp/out" 2> "$tmp/err" < /dev/null || status=$?
  [ $status = "$want" ] || { echo "ended with $status, not $want: $*"; head -3 "$tmp/err"; return 1; }
}

# refused WORDS COMMAND...: ends with 2, nothing on stdout, one line on stderr that holds the words
# and after a semicolon what would be right.
refused() {
  local words=$1
  shift
  ends 2 "$@" || return 1
  [ ! -s "$tmp/out" ] && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -qF -- "$words" "$tmp/err" || {
    echo "wanted one line with: $words"; head -3 "$tmp/err"; return 1; }
}

# value QUANTITY DIR: of DIR/summary.tsv.
value() { awk -F'\t' -v q="$1" '$1 == q { print $2 }' "$2/summary.tsv"; }
