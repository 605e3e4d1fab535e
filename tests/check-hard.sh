#!/bin/bash
# tests/check-hard.sh: every hard case but the longest keeps its promise; slow-hard.sh and the book have them all.
. tests/tell.sh
tests/hard "$tmp/hard.tsv" short 2> "$tmp/err"
while IFS=$'\t' read -r name provoked promised measured pass; do
  [ "$pass" = pass ] || echo "promised $promised; measured $measured"
  tell "hard case: $name ($provoked)" test "$pass" = pass
done < "$tmp/hard.tsv"
tell 'there are at least thirty' test "$(wc -l < "$tmp/hard.tsv")" -ge 30
exit $failed
