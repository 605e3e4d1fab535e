#!/bin/bash
# tests/check-hard.sh: every hard case keeps its promise, and all but the longest twice with the same words.
. tests/tell.sh
tests/hard "$tmp/hard.tsv" 2> "$tmp/err"
while IFS=$'\t' read -r name provoked promised measured pass; do
  [ "$pass" = pass ] || echo "promised $promised; measured $measured"
  tell "hard case: $name ($provoked)" test "$pass" = pass
done < "$tmp/hard.tsv"
tell 'there are at least thirty' test "$(wc -l < "$tmp/hard.tsv")" -ge 30
tests/hard "$tmp/again.tsv" short 2> /dev/null
again() { grep -vxFf "$tmp/again.tsv" "$tmp/hard.tsv" > "$tmp/once"; [ "$(wc -l < "$tmp/once")" = "$(grep -c '^long row' tests/hard)" ] &&
  grep -vxFf "$tmp/once" "$tmp/hard.tsv" | cmp - "$tmp/again.tsv"; }
tell 'the table is the same every time, but for the longest cases' again
exit $failed
