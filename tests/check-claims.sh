#!/bin/bash
# tests/check-claims.sh: verdicts by paper/findings.awk, for each rule and error; and what figures/gravity/touch.awk counts in packs that are known.
. tests/tell.sh
mkdir -p "$tmp/run"
# judged RULE VALUE ERROR [MEASURED]: the verdict.
judged() {
  printf 'quantity\tvalue\tstandard_error\na\t%s\t%s\nb\t2\t0.2\n' "$2" "$3" > "$tmp/run/summary.tsv"
  printf 'X\t1\ta claim\t%s\t%s\tso\tnot so\n' "${4:-run@a}" "$1" > "$tmp/claims.tsv"
  awk -f paper/findings.awk "$tmp/claims.tsv" "$tmp/run/summary.tsv" 2> "$tmp/err" | awk -F'\t' 'NR == 2 { print $5 ($10 == "" ? "" : ", " $10) }'
}
# is VERDICT RULE VALUE ERROR [MEASURED]
is() { local want=$1; shift; local got; got=$(judged "$@"); [ "$got" = "$want" ] || { echo "$got, not $want"; return 1; }; }
while IFS='|' read -r words want rule v e; do
  tell "$words" is "$want" "$rule" "$v" "$e"
done <<'END'
half a unit of the last digit printed|holds, so|~ 9.55|9.5493|0
beyond it|does not hold, not so|~ 190.9|190.986|0
an error that reaches over both ends|undecided|~ 0.868|0.868|0.001
an error of four times that is short of the claim|does not hold, not so|~ 0.21|0.25|0.008
a noisier measurement of the same is undecided|undecided|~ 0.21|0.25|0.01
about: a whole unit|holds, so|~ about 8.3|8.39|0
zeros at the end are digits|does not hold, not so|~ 4.0|4.06|0
a printed range|does not hold, not so|in 0.60 0.75|0.755|0
a range at about|holds, so|in about 0.60 0.75|0.755|0
the same, to two per cent|holds, so|same|0.985|0.001
not the same|does not hold, not so|same|1.05|0.007
above, with its error|holds, so|> 1|1.05|0.012
above but for its error|undecided|> 1|1.05|0.013
below|does not hold, not so|< -0.01|0.02|0.007
exact|does not hold, not so|= 587|590|0
END
tell 'a ratio has the errors of both' is undecided '~ 1.0' 2 0 'run@a / run@b'
tell 'a difference, too' is 'does not hold, not so' '> 0' 1 0.1 'run@a - run@b'
tell 'a row that is missing is zero if so marked' is 'holds, so' '= 0' 1 0 'run@c|0'
tell 'what nothing decides is untested' is 'untested, not so' - 1 0 -
# complains WORDS RULE VALUE ERROR [MEASURED]
complains() { local words=$1; shift; judged "$@" > /dev/null; grep -q -- "$words" "$tmp/err"; }
tell 'an exact claim of a noisy quantity is no claim' complains 'exact' '= 1' 1 0.1
tell 'nor one by an unknown rule' complains 'no such rule' 'near 1' 1 0
tell 'nor one of an unknown quantity' complains 'no quantity' same 1 0 run@d

# A chain of five touching spheres in a finite pack, of which the ends have one contact each, and one sphere apart; all in the core.
finite() {
  echo 6; echo 'Lattice="80 0 0 0 80 0 0 0 80" Properties=species:S:1:pos:R:3:radius:R:1 pbc="F F F" open=20 seed=1 realization=0'
  for x in 36 38 40 42 44; do echo "a $x 40 40 1"; done; echo 'a 40 45 40 1'
}
# A sphere in a corner of a periodic box with others at 2.01 along x, across the side of the box, and at 2.005 along y.
corner() { echo 3; echo 'Lattice="8 0 0 0 8 0 0 0 8" Properties=species:S:1:pos:R:3:radius:R:1 pbc="T T T"'; echo 'a 7.5 1 1 1'; echo 'a 1.51 1 1 1'; echo 'a 7.5 3.005 1 1'; }
# Of its 26 directions (1, 1, 0) and (1, 1, -1 and 1) meet both; the share of a way beyond the nearer, over all directions of the three.
expected=$(awk 'function way(d, c) { return d * c - sqrt(d * d * c * c - d * d + 4) }
  BEGIN { a = sqrt(1 / 2); b = sqrt(1 / 3); printf "%.12g", (1 - way(2.005, a) / way(2.01, a) + 2 * (1 - way(2.005, b) / way(2.01, b))) / 78 }')
finite > "$tmp/finite.xyz"; corner > "$tmp/corner.xyz"; corner | sed 's/3.005/3.05/' > "$tmp/far.xyz"
# counts QUANTITY VALUE PACK...
counts() {
  local q=$1 v=$2; shift 2
  awk -f figures/gravity/touch.awk "$@" | awk -F'\t' -v q="$q" -v v="$v" '$1 == q { good = ($2 - v) ^ 2 < 1e-15 } END { exit !good }'
}
tell 'spheres with fewer than two contacts: the ends of a chain and a single one' counts lonely 0.5 "$tmp/corner.xyz" "$tmp/finite.xyz" "$tmp/finite.xyz"
tell 'moves beyond the first of two spheres that are met' counts beyond "$expected" "$tmp/corner.xyz" "$tmp/finite.xyz" "$tmp/finite.xyz"
tell 'none if the second is out of the testing window' counts beyond 0 "$tmp/far.xyz" "$tmp/finite.xyz" "$tmp/finite.xyz"
# How many seeds of a sweep were freed of overlap, and the means over these.
rated() {
  mkdir -p "$tmp/relax-dense" "$tmp/relax-literal"
  printf 'seed\treached\trelax_steps\tQ6_local\n3\t1\t20\t0.5\n4\t0\tnan\tnan\n# not reached\n5\t1\t26\t0.75\n' > "$tmp/relax-dense/sweep.tsv"
  printf 'make.friction\tseed\treached\trelax_steps\tQ6_local\n0\t1\t0\tnan\tnan\n0.5\t1\t1\t7\t0.25\n' > "$tmp/relax-literal/sweep.tsv"
  diff <(printf '%s\n' freed@dense:2:0 packs@dense:3:0 steps@dense:23:3 order@dense:0.625:0.125 freed@0:0:0 packs@0:1:0 freed@0.5:1:0 packs@0.5:1:0 \
    steps@0.5:7:nan order@0.5:0.25:nan) <(awk -f figures/shapes/relax-rate.awk "$tmp"/relax-{dense,literal}/sweep.tsv | tail -n +3 | tr '\t' ':')
}
tell 'seeds that were freed are counted, and averaged over' rated
exit $failed
