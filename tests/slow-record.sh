#!/bin/bash
# tests/slow-record.sh: recorded seconds of other code are read all the same, and counted as such.
. tests/tell.sh
other() { awk -F'\t' '$1 == "other_code" { print $2 }' "$tmp/$1/summary.tsv"; }
read_record() { build/bench recorded "$1" "$tmp/$2" && [ -s "$tmp/$2/machine.tex" ] && [ "$(wc -l < "$tmp/$2/summary.tsv")" -gt 100 ]; }
tell 'the record can be read' read_record data/bench-seconds.tsv own
sed 's/[0-9a-f]\{16\}$/0123456789abcdef/' data/bench-seconds.tsv > "$tmp/old.tsv"
tell 'and one of other code, too' read_record "$tmp/old.tsv" old
tell 'which is told' test "$(other old)" -ge 10
same() { diff <(sed '/^#/d; /^other_code/d' "$tmp/own/summary.tsv") <(sed '/^#/d; /^other_code/d' "$tmp/old/summary.tsv"); }
tell 'its numbers are the same' same
exit $failed
