#!/bin/bash
# tests/check-verdicts.sh: the rule by which claims are judged, the signs of what is recorded, and the settings of a draft, on made-up
# tables whose verdicts are known.
. tests/tell.sh
mkdir -p "$tmp/one" "$tmp/kept" "$tmp/seconds"
head='quantity\tvalue\tstandard_error\n'
printf "$head"'sharp\t0.4321\t0.0001\nwide\t0.43\t0.002\nnone\t2\tnan\nzero\t0\t0\nunity\t1.012\t0.0015\nq\t8.4137\t0.0068\n' > "$tmp/one/summary.tsv"
printf "$head"'x\t12.3456\t0.0789\n' > "$tmp/kept/summary.tsv"
tables=("$tmp/one/summary.tsv" "$tmp/kept/summary.tsv")
judged() { # judged MEASURED RULE: the verdict, with what is claimed and the tolerance
  printf 'B\t(1)\tit is\t%s\t%s\tyes\tno\n' "$1" "$2" > "$tmp/claims"
  awk -f paper/findings.awk "$tmp/claims" "${tables[@]}" | awk -F'\t' 'NR == 2 { print $5 "|" $7 "|" $8 "|" $10 }'
}
is() { local got; got=$(judged "$1" "$2"); [ "$got" = "$3" ] || { echo "$got"; return 1; }; }
while IFS=';' read -r measured rule expected; do
  tell "$measured, claimed $rule" is "$measured" "$rule" "$expected"
done <<'END'
one@sharp;~ 0.43;holds|0.43|0.005|yes
one@sharp;~ 0.432;holds|0.432|0.0005|yes
one@sharp;~ 0.4321;undecided|0.4321|5e-05|
one@sharp;~ 0.43210;undecided|0.43210|5e-06|
one@sharp;~ 0.434;does not hold|0.434|0.0005|no
one@sharp;~ about 0.43;holds|about 0.43|0.01|yes
one@wide;~ 0.43;undecided|0.43|0.005|
one@wide;~ about 0.43;holds|about 0.43|0.01|yes
one@wide;~ 0.45;does not hold|0.45|0.005|no
one@none;~ 2;holds|2|0.5|yes
one@none;~ 12;does not hold|12|0.5|no
one@q;~ 8.4;holds|8.4|0.05|yes
one@q;~ 8.41;undecided|8.41|0.005|
one@q;~ 8.3;does not hold|8.3|0.05|no
one@none;= 2;holds|2|0|yes
one@none;= 2.00001;does not hold|2.00001|0|no
one@wide;in 0.40 0.45;holds|0.40 to 0.45|0|yes
one@wide;in 0.40 0.43;undecided|0.40 to 0.43|0|
one@wide;in 0.5 0.6;does not hold|0.5 to 0.6|0|no
one@wide;< 0.44;holds|< 0.44|-|yes
one@wide;< 0.435;undecided|< 0.435|-|
one@wide;> 0.44;does not hold|> 0.44|-|no
one@unity;same;holds|1|0.02|yes
one@wide / one@sharp;same;undecided|1|0.02|
one@unity - one@none;~ -0.988;undecided|-0.988|0.0005|
one@gone|0;= 0;holds|0|0|yes
END
complains() { printf "$1" > "$tmp/claims"; ! awk -f paper/findings.awk "$tmp/claims" "${tables[@]}" > /dev/null 2> "$tmp/said" && grep -q "$2" "$tmp/said"; }
tell 'a quantity that nobody measured' complains 'B\t\tx\tone@gone\t< 1\t\t\n' 'row B1: no quantity one@gone'
tell 'a rule that there is not' complains 'B\t\tx\tone@wide\tnear 1\t\t\n' 'no such rule: near 1'
tell 'an exact claim of a mean' complains 'B\t\tx\tone@wide\t= 0.43\t\t\n' 'an exact claim'
tell 'a row with a column missing' complains 'B\t\tx\tone@wide\t< 1\t\n' 'not seven columns'
counted() {
  printf 'B\t\tx\tone@wide\t< 1\t\t\nG\t\tx\t-\t-\t\tits data cannot be read\nB\t\tx\tone@wide\t> 1\t\t\nB\t\tx\tkept@x\t< 12\t\t\n' > "$tmp/claims"
  awk -f paper/findings.awk "$tmp/claims" "${tables[@]}" > "$tmp/findings" &&
    awk -v score="$tmp/score" -v recorded=kept -f paper/findings-tex.awk "$tmp/findings" > "$tmp/table" &&
    grep -qF '\sourceB & 1 & 2 & 0 & 0' "$tmp/score" && grep -qF '\sourceG & 0 & 0 & 0 & 1' "$tmp/score" &&
    [ "$(cut -f 6 "$tmp/findings" | paste -sd' ')" = 'number B1 G1 B2 B3' ] && grep -qF '$12.346(79)$\recorded' "$tmp/table" &&
    [ "$(grep -cF '\recorded' "$tmp/table")" = 1 ]
}
tell 'verdicts are counted by source, and recorded ones bear a sign' counted
draft() { printf 'B\t\tx\tone@gone\t< 1\t\t\n' > "$tmp/claims"; awk -v draft=1 -f paper/findings.awk "$tmp/claims" "${tables[@]}" | grep -q 'untested.*not in this draft'; }
tell 'a draft may lack a quantity' draft
twice() {
  printf 'B\t\tx\tone@gone\t< 1\t\t\nB\t\ty\tone@gone\t< 1\t\t\n' > "$tmp/claims"
  [ "$(awk -v draft=1 -f paper/findings.awk "$tmp/claims" "${tables[@]}" | grep -c 'untested.*not in this draft')" = 2 ]
}
tell 'and two claims may need it' twice

printf 'kept@x\none@q\nseconds@rate\n' > "$tmp/used"
signs() { awk -v recorded='kept seconds' -f paper/values.awk "$tmp/used" "${tables[@]}" "$tmp/seconds/summary.tsv" > "$tmp/values"; }
seconds() { printf "$head"'other_code\t%s\tnan\nrate\t2.5\t0.1\n' "$1" > "$tmp/seconds/summary.tsv"; signs; }
own() { seconds 0 && grep -qF 'val@kept@x\endcsname{12.346(79)\recorded}' "$tmp/values" && grep -qF 'val@one@q\endcsname{8.4137(68)}' "$tmp/values" &&
  grep -qF 'only@seconds@rate\endcsname{2.50\recorded}' "$tmp/values"; }
tell 'a number of a recorded run bears the sign, and no other does' own
tell 'a number that the prose does not name is not defined' test "$(grep -c csname "$tmp/values")" = 3
other() { seconds 3 && grep -qF 'val@seconds@rate\endcsname{2.50(10)\othercode}' "$tmp/values" && grep -qF '\recorded}' "$tmp/values"; }
tell 'seconds of other code bear another sign' other
printf '# data: one kept\n' > "$tmp/a.gp" && printf '# data: one\n' > "$tmp/b.gp" && printf '# data: one data/bench-seconds.tsv\n' > "$tmp/c.gp"
printf 'It is \\val{kept}{x}, \\valonly{one}{q} and \\val{kept}{x}.\n' > "$tmp/web.nw"
figures() { awk -v recorded='kept seconds' -v runs=7 -v other="$1" -f paper/recorded.awk "$tmp"/[abc].gp "$tmp/web.nw" > "$tmp/recorded"; }
drawn() { figures 0 && [ "$(grep -c 'plot@' "$tmp/recorded")" = 2 ] && grep -qF 'plot@a\endcsname{\recorded}' "$tmp/recorded" &&
  grep -qF '\recordedruns{7}\def\recordednumbers{2}\def\numbers{3}\def\recordedplots{2}\def\plots{3}' "$tmp/recorded" && ! grep -q otherseconds "$tmp/recorded"; }
tell 'recorded figures and numbers are counted' drawn
changed() { figures 1 && grep -qF 'plot@c\endcsname{\othercode}' "$tmp/recorded" && grep -q otherseconds "$tmp/recorded"; }
tell 'a figure of seconds of other code says so' changed

few() { printf "$1" > "$tmp/x.scene"; [ "$(paper/few "$tmp/x.scene" 2)" = "$2" ]; }
tell 'a draft takes two packs of fifty' few 'realizations = 50;\n' '--set realizations=2'
tell 'and no more than there are' few 'realizations = 1;\n' ''
tell 'and what the scene says' few '# draft: --set fraction=0.4\nrealizations = 9;\n' '--set realizations=2 --set fraction=0.4'
exit $failed
