#!/bin/bash
# tests/check-growth.sh: growth, pressure and sweeps as a scene asks for them.
. tests/tell.sh
shopt -s nullglob
say() { printf '%s\n' "$2" > "$tmp/$1.scene"; }            # say NAME TEXT
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...

# audit PACK FRACTION: |fraction - wanted| < 1e-14 and no overlap beyond 1e-12 of a diameter, by brute force.
audit() {
  awk -v wanted="$2" 'NR == 2 { split($0, w, /[" ]/); L[1] = w[2]; L[2] = w[6]; L[3] = w[10]; flat = /pbc="T T F"/ }
    NR > 2 { n++; for (k = 1; k <= 3; k++) x[n, k] = $(k + 1); a[n] = $5; a[n] > big && big = a[n] }
    function near(d, l) { return d > l / 2 ? d - l : d < -l / 2 ? d + l : d }
    END { pi = 3.14159265358979323846; d = flat ? 2 : 3
      for (i = 1; i <= n; i++) solid += flat ? a[i] ^ 2 : a[i] ^ 3
      phi = flat ? pi * solid / (L[1] * L[2]) : 4 * pi / 3 * solid / (L[1] * L[2] * L[3])
      for (i = 1; i <= n; i++) for (j = 1; j < i; j++) {
        for (r = k = 0; k++ < d;) r += near(x[j, k] - x[i, k], L[k]) ^ 2
        gap = sqrt(r) - a[i] - a[j]; if (!seen++ || gap < least) least = gap }
      if (least < -2e-12 * big || (phi - wanted) ^ 2 > 1e-28) { print "fraction", phi - wanted, "gap", least; exit 1 } }' "$1"
}
say one 'dimension = 3; species = ( { name = "A"; radius = 1.0; number = 200; } ); fraction = 0.55;
make = { method = "crm"; growth = 0.1; }; measure = { rdf = { reach = 4.0; step = 0.1; }; order = {}; }; save = true;'
say flat 'dimension = 2; box = [1.0, 1.5]; species = ( { name = "A"; radius = 0.7; number = 100; },
  { name = "B"; radius = 0.3; number = 150; } ); fraction = 0.78; make = { method = "crm"; growth = 0.5; protocol = "literal";
  mass = "volume"; start = "rsa"; }; measure = { nearest = {}; coordination = {}; pressure = { warm = 5; each = 5; }; };
save = true;'

# --- a gap
say gap 'dimension = 3; gap = 0.2; fraction = 0.45; number = 100; save = true; make = { method = "crm"; growth = 0.1; };
species = ( { name = "A"; radius = 1.0; share = 0.5; sizes = { law = "lognormal"; spread = 0.2; }; }, { name = "B"; radius = 2.0; share = 0.5; } );'
keeps() { awk -v gap="$(value min_gap "$tmp/gap")" 'BEGIN { exit !(gap >= 0.1 * (1 - 1e-9) && gap < 0.11) }'; }
gapped() { run gap gap "$@" && audit "$tmp/gap/pack-0.xyz" 0.45 && keeps; }
tell 'growth keeps a gap and lands on the fraction' gapped
tell 'from a pack by rsa, too' gapped --set make.start=rsa --set make.start_fraction=0.15
jammed() { run gap gap --set fraction=max && keeps && [ "$(awk 'NR > 2 && $1 == "B" { print $5 }' "$tmp/gap/pack-0.xyz" | sort -u)" = 2 ]; }
tell 'and jams with it' jammed
again() { cp "$tmp/gap/pack-0.xyz" "$tmp/loose.xyz" && sed '/^species/d; s/number = 100; //' "$tmp/gap.scene" > "$tmp/from.scene" &&
  ends 0 "$randpack" run "$tmp/from.scene" --set "make.start=$tmp/loose.xyz" --set fraction=0.48 --out "$tmp/gap" && audit "$tmp/gap/pack-0.xyz" 0.48 && keeps; }
gapped --set gap=0.2 --set fraction=0.45 > "$tmp/out" && tell 'and grows on from such a pack' again
tell 'but not from one without' refused 'surfaces in the pack to start from are nearer than gap, by' \
  "$randpack" run "$tmp/from.scene" --set "make.start=$tmp/loose.xyz" --set gap=0.3 --set fraction=0.5 --out "$tmp/new"

# --- landing
lands() { run "$1" "$1" && audit "$tmp/$1/pack-0.xyz" "$2" && [ "$(value collisions "$tmp/$1")" -gt 500 ]; }
tell 'spheres land on the fraction without overlap' lands one 0.55
tell 'discs of two sizes, from a pack by rsa, too' lands flat 0.78
rows() {
  for q in fraction min_gap collisions time gamma heating unaccounted drift pressure; do
    [ -n "$(value $q "$tmp/one")" ] || { echo "no row $q"; return 1; }
  done
  awk -F'\t' '/^unaccounted|^drift/ && $2 > 1e-12 || /^gamma/ && ($2 - 0.1) ^ 2 > 1e-24 { print; bad = 1 } END { exit bad }' \
    "$tmp/one/summary.tsv"
}
tell 'the summary accounts for the growth' rows
chosen() { # chosen SETTING: it makes another pack, as full
  run flat chosen --set "make.$1" && audit "$tmp/chosen/pack-0.xyz" 0.78 && ! cmp -s "$tmp"/{flat,chosen}/pack-0.xyz
}
for setting in mass=equal protocol=isothermal start_fraction=0.3 start=points growth=0.4; do
  tell "$setting is another pack" chosen $setting
done
hot() { awk -F'\t' '$1 == "heating" && $2 > 2 { hot = 1 } END { exit !hot }' "$tmp/flat/summary.tsv"; }
tell 'literal growth heats' hot
jams() {
  ends 1 "$randpack" run "$tmp/one.scene" --set fraction=0.73 --out "$tmp/jam" && [ "$(wc -l < "$tmp/err")" = 1 ] &&
    grep -qE 'at fraction 0\.[56][0-9]+ of 0\.730000 after [0-9]+ collisions' "$tmp/err" && [ -z "$(ls "$tmp/jam" 2> /dev/null)" ]
}
tell 'a pack that jams below the fraction: status 1, and what was reached' jams
intervals() { run one interval --set make.interval=20 && audit "$tmp/interval/pack-0.xyz" 0.55 && ! cmp -s "$tmp"/{one,interval}/pack-0.xyz; }
tell 'another interval is another pack' intervals
rests() { run one rest --set make.rest=20 && audit "$tmp/rest/pack-0.xyz" 0.55 && ! cmp -s "$tmp"/{one,rest}/pack-0.xyz &&
    [ "$(value collisions "$tmp/rest")" -ge $(($(value collisions "$tmp/one") + 1800)) ]; }
tell 'a rest moves the particles and keeps the fraction' rests
limited() { ends 1 "$randpack" run "$tmp/one.scene" --set "make.$1" --out "$tmp/jam" && grep -q "$2" "$tmp/err"; }
tell 'a budget is kept' limited budget=3 'budget of collisions is used up'
tell 'a pressure is kept' limited pressure=12 'the pack is jammed'

# --- from a pack
again() {
  say again "dimension = 3; fraction = 0.6; make = { method = \"crm\"; start = \"$tmp/one/pack-0.xyz\"; growth = 0.1; }; save = true;"
  run again again && audit "$tmp/again/pack-0.xyz" 0.6 && [ "$(value number "$tmp/again")" = 200 ] &&
    awk 'NR > 2 && ($5 - 1) ^ 2 > 1e-28 { exit 1 }' "$tmp/again/pack-0.xyz"
}
tell 'a saved pack grows on, and its particles keep their size' again
stays() {
  run again stays --set fraction=0.55 && audit "$tmp/stays/pack-0.xyz" 0.55 && awk 'FNR == 2 { split($0, w, /[" ]/); L = w[2] } FNR > 2 {
    for (k = 1; k <= 3; k++) if (NR == FNR) x[FNR, k] = $(k + 1) / L
      else { d = $(k + 1) / L - x[FNR, k]; d -= d > 0.5; d += d < -0.5; if (d * d > 1e-12) { print "moved by", d; exit 1 } } }' \
    "$tmp/one/pack-0.xyz" "$tmp/stays/pack-0.xyz"
}
tell 'it starts where it was, and may stay there' stays
from_pack() { tell "$1" refused "$2" "$randpack" run "$tmp/again.scene" --out "$tmp/new" "${@:3}"; }
from_pack 'a start denser than the fraction' 'again.scene:1: the pack to start from is denser than fraction; give' --set fraction=0.5
from_pack 'a start of another dimension' 'the pack to start from has no particles, or another dimension; give' --set dimension=2
sed 's/fraction = 0.6;//' "$tmp/again.scene" > "$tmp/bare.scene"
tell 'a start without fraction' refused "$tmp/bare.scene:1: fraction is missing in the scene; give" "$randpack" plan "$tmp/bare.scene"
sed 's/pbc="T T T"/pbc="T T F"/' "$tmp/one/pack-0.xyz" > "$tmp/slab.xyz"
from_pack 'a start from a slab' 'the pack to start from is not periodic; give one in a periodic box' --set "make.start=$tmp/slab.xyz"
from_pack 'a start, and species' 'the pack to start from gives the particles and the box; leave' --set 'species=({radius=1.0;number=200;})'
from_pack 'a start, and a box' 'the pack to start from gives the particles and the box; leave' --set 'box=[1,1,2]'
from_pack 'a start, and too long a reach' 'measure.rdf.reach = 6 goes beyond half the box; the largest reach here is 5.' --set 'measure.rdf.reach=6.0'
sed 's/ 1$/ 1.5/' "$tmp/one/pack-0.xyz" > "$tmp/over.xyz"
from_pack 'a start that overlaps' 'the pack to start from overlaps, by ' --set "make.start=$tmp/over.xyz" --set fraction=0.9
sizes() { # a radius a particle
  awk 'NR > 2 { $5 *= 1 - NR / 1000 } { print }' "$tmp/one/pack-0.xyz" > "$tmp/sizes.xyz"
  run again sizes --set "make.start=$tmp/sizes.xyz" --set fraction=0.5 && audit "$tmp/sizes/pack-0.xyz" 0.5 &&
    awk 'FNR > 2 && NR == FNR { a[FNR] = $5 } FNR > 2 && NR > FNR && ($5 / a[FNR] - 1) ^ 2 > 1e-28 { exit 1 }' \
      "$tmp/sizes.xyz" "$tmp/sizes/pack-0.xyz"
}
tell 'a start with a radius a particle' sizes

# --- pressure
apart() {
  run flat apart && run flat plain --set measure.pressure.warm=70 && cmp "$tmp"/{apart,plain}/pack-0.xyz &&
    [ "$(value Z "$tmp/apart")" != "$(value Z "$tmp/plain")" ] && [ -z "$(value contact_collision "$tmp/apart")" ]
}
tell 'the pressure is measured on a copy' apart
pressure() { # Z = 1 + 4 phi g, and Carnahan and Starling's Z at 0.3 within 4 standard errors and 1 %
  run one z --set fraction=0.3 --set measure.pressure.each=100.0 --set measure.contact.step=0.01 &&
    awk -F'\t' '$1 == "Z" { Z = $2; e = $3 } $1 == "contact_collision" { g = $2 } $1 ~ /_after$/ { after++ } END {
      cs = (1 + .3 + .09 - .027) / .343; exit !(e > 0 && (Z - cs) ^ 2 < (4 * e + 0.01 * cs) ^ 2 &&
      (Z - 1 - 1.2 * g) ^ 2 < 1e-18 && after == 2) }' "$tmp/z/summary.tsv"
}
tell 'Z at 0.3 is that of the fluid, the contact value follows, and order is told after it' pressure
measured_again() { # the numbers of the pack itself come out of its file again
  ends 0 "$randpack" measure "$tmp/$1/pack-0.xyz" --scene "$tmp/$1.scene" --out "$tmp/$1-again" &&
    diff <(grep -vE '^(collisions|time|gamma|heating|unaccounted|drift|pressure|attempts|trials)' "$tmp/$1/summary.tsv") "$tmp/$1-again/summary.tsv"
}
tell 'a grown pack measures the same when read back' measured_again flat
over() { ends 2 "$randpack" measure "$tmp/over.xyz" --scene "$tmp/one.scene" --set 'measure={pressure={};}' --out "$tmp/new" &&
    grep -q 'over.xyz: particles [0-9]* and [0-9]* overlap by .* of the smallest radius, and measure.pressure needs hard particles; relax them' "$tmp/err"; }
tell 'no pressure of a pack that overlaps' over

# --- jamming
jammed() {
  run one max --set fraction=max --set "make.$1" --set make.pressure=1e4 --set measure.coordination.tolerance=3e-3 && [ "$(value number "$tmp/max")" = 200 ] &&
    awk -F'\t' '$1 == "fraction" { phi = $2 } $1 == "pressure" { Z = $2 }
      $1 == "backbone_coordination" { held = $2 } $1 == "rattlers" { rattlers = $2 } END { exit !(phi > 0.58 && phi < 0.7 && Z > 1e4 && held > 5 && held < 6.3 && rattlers < 0.2) }' \
      "$tmp/max/summary.tsv" && awk 'NR > 2 && ($5 - 1) ^ 2 > 1e-28 { exit 1 }' "$tmp/max/pack-0.xyz" &&
    audit "$tmp/max/pack-0.xyz" "$(awk 'NR == 2 { split($0, w, /[" ]/); printf "%.17g", 200 * 4 * 3.14159265358979323846 / 3 / w[2] ^ 3 }' "$tmp/max/pack-0.xyz")"
}
tell 'fraction = "max" grows points until they are jammed' jammed start=points
tell 'a pack by rsa too' jammed start=rsa
isostatic() { # as many contacts in the backbone as degrees of freedom
  run one iso --set fraction=max --set "$1" --set "species=$2" --set realizations=1 --set make.growth=0.1 \
    --set 'measure={ coordination = { tolerance = 3e-6; }; }' &&
    awk -F'\t' '$1 == "isostatic_excess" { excess = $2; n++ } $1 == "backbone_coordination" { held = $2 }
      END { exit !(n == 1 && excess == 0 && held > 3.5) }' "$tmp/iso/summary.tsv"
}
tell 'jammed discs of two sizes are isostatic' isostatic dimension=2 '( { name = "A"; radius = 1.4; number = 40; }, { name = "B"; radius = 1.0; number = 40; } )'
tell 'jammed spheres of two sizes are isostatic' isostatic dimension=3 '( { name = "A"; radius = 1.4; number = 30; }, { name = "B"; radius = 1.0; number = 30; } )'

# --- sweeps
say sweep 'dimension = 3; realizations = 2; species = ( { radius = 1.0; number = 60; } );
make = { method = "crm"; growth = 0.3; }; measure = { rdf = { reach = 2.9; step = 0.1; }; contact = {}; }; save = true;
sweep = ( { key = "make.protocol"; values = ("literal", "isothermal"); }, { key = "fraction"; values = (0.3, 0.4, 45e-2); } );'
table() { grep -v '^#' "$1"; }
combined() { # each combination has the numbers, curves and packs that it has alone
  run sweep sweep || return 1
  local p f q
  for p in literal isothermal; do for f in 0.3 0.4 0.45; do
    q=@$p@$f
    run sweep single --set 'sweep=()' --set make.protocol=$p --set fraction=$f || return 1
    diff <(table "$tmp/single/rdf.tsv") <(table "$tmp/sweep/rdf$q.tsv") && cmp "$tmp/single/pack-1.xyz" "$tmp/sweep/pack-1$q.xyz" &&
      diff <(table "$tmp/single/summary.tsv" | sed 1d) <(table "$tmp/sweep/summary.tsv" | grep "$q	" | sed "s/$q	/	/; /^reached/d") &&
      diff <(table "$tmp/single/summary.tsv" | sed 1d | cut -f2,3 | tr '\n' '\t') \
        <(table "$tmp/sweep/sweep.tsv" | grep "^$p	$f	" | cut -f5- | tr '\n' '\t') || { echo "$q"; return 1; }
  done; done
  [ "$(table "$tmp/sweep/sweep.tsv" | cut -f1,2 | sed 1d | tr '\n\t' '; ')" = \
    'literal 0.3;literal 0.4;literal 0.45;isothermal 0.3;isothermal 0.4;isothermal 0.45;' ]
}
tell 'a sweep has the numbers of its scenes, the first key slowest' combined
headed() { head -1 <(table "$tmp/sweep/sweep.tsv") | grep -q '^make.protocol	fraction	reached	reached_err	realizations	realizations_err	' &&
    grep -qx '# fraction = 0.45' "$tmp/sweep/rdf@literal@0.45.tsv"; }
tell 'its tables say which is which' headed
planned() {
  diff <("$randpack" plan "$tmp/sweep.scene" | sed -n 's/^write\t *//p' | tr ' ' '\n' |
    sed 's/pack-K\(.*\)/pack-0\1\npack-1\1/' | sort) <(ls "$tmp/sweep" | sort) &&
    [ "$("$randpack" plan "$tmp/sweep.scene" | grep -c '^sweep')" = 6 ]
}
tell 'and are those of the plan' planned
unreached() { # unreached STATUS SETTING...: one of two combinations jams
  ends "$1" "$randpack" run "$tmp/sweep.scene" --set 'sweep=({key="fraction";values=[0.3,0.73];})' --out "$tmp/half" "${@:2}" &&
    [ "$(value reached@0.3 "$tmp/half")$(value reached@0.73 "$tmp/half")" = 10 ] && [ -n "$(value contact@0.3 "$tmp/half")" ] &&
    [ -z "$(value contact@0.73 "$tmp/half")" ] && [ ! -e "$tmp/half/rdf@0.73.tsv" ] &&
    grep -q '^# the pack is jammed at fraction' "$tmp/half/sweep.tsv" &&
    [ "$(table "$tmp/half/sweep.tsv" | tail -1 | cut -f1-4)" = "0.73	0	0	nan" ]
}
fails() { unreached 1 && [ "$(wc -l < "$tmp/err")" = 1 ] && grep -q '1 of 2 combinations not reached; the first, @0.73: the pack' "$tmp/err"; }
keeps() { unreached 0 --set unreached=keep && [ ! -s "$tmp/err" ]; }
tell 'a combination that jams does not lose the others, but the status' fails
tell 'unless the scene expects it' keeps
say keep "$(cat "$tmp/sweep.scene") unreached = \"keep\";"
alone() { ends "$1" "$randpack" run "$tmp/keep.scene" --set 'sweep=()' --set fraction="$2" --out "$tmp/alone"; }
tell 'such a scene runs without its sweep' alone 0 0.3
tell 'and then expects nothing' alone 1 0.73
of_sweep() { tell "$1" refused "$2" "$randpack" "$3" "${@:4}" --out "$tmp/new"; }
of_sweep 'a key that is swept and set' 'sweep.scene:3: this key is swept, and set too; give' run "$tmp/sweep.scene" --set fraction=0.2
of_sweep 'a sweep to measure a pack' 'a sweep makes its packs; give --set sweep=()' measure "$tmp/one/pack-0.xyz" --scene "$tmp/sweep.scene"
of_sweep 'a sweep from the command line' ':--set: growht is not a key of make; known here' run "$tmp/one.scene" --set 'sweep=({key="make.growht";values=[1];})'
of_sweep 'the last of six is wrong' 'sweep.scene:--set: fraction has a wrong value' run "$tmp/sweep.scene" \
  --set 'sweep=({key="seed";values=[1,2];},{key="fraction";values=[0.2,0.3,1.0];})'
tell 'nothing was written' test ! -e "$tmp/new"
exit $failed
