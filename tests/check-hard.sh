#!/bin/bash
# tests/check-hard.sh: every hard case keeps its promise, twice with the same table.
. tests/tell.sh
tests/hard "$tmp/hard.tsv" 2> "$tmp/err"
while IFS=$'\t' read -r name provoked promised measured pass; do
  [ "$pass" = pass ] || echo "promised $promised; measured $measured"
  tell "hard case: $name ($provoked)" test "$pass" = pass
done < "$tmp/hard.tsv"
tell 'there are at least thirty' test "$(wc -l < "$tmp/hard.tsv")" -ge 30
tests/hard "$tmp/again.tsv" 2> /dev/null
tell 'the table is the same every time' cmp "$tmp/hard.tsv" "$tmp/again.tsv"
exit $failed
