#!/bin/bash
# tests/slow-hard.sh: every hard case keeps its promise, and all but the longest twice with the same words.
. tests/tell.sh
tell 'every hard case keeps its promise' tests/hard "$tmp/hard.tsv"
tests/hard "$tmp/again.tsv" short 2> /dev/null
again() { grep -vxFf "$tmp/again.tsv" "$tmp/hard.tsv" > "$tmp/once"; [ "$(wc -l < "$tmp/once")" = "$(grep -c '^long row' tests/hard)" ] &&
  grep -vxFf "$tmp/once" "$tmp/hard.tsv" | cmp - "$tmp/again.tsv"; }
tell 'the table is the same every time, but for the longest cases' again
exit $failed
