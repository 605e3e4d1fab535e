#!/bin/bash
# tests/check-sizes.sh: species whose sizes follow a law, by number, volume and mass, made by every method.
. tests/tell.sh
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
cat > "$tmp/one.scene" <<'END'
dimension = 3; seed = 4; realizations = 2; number = 700; fraction = 0.55;
species = ( { name = "A"; radius = 2.0; mass = 3.0; density = 1.5; sizes = { law = "lognormal"; spread = 0.25; most = 5.0; }; },
            { name = "B"; mass = 1.0; density = 1.0; sizes = { law = "sieve"; radii = [1.0, 1.5, 2.0, 3.0]; passing = [0, 30, 30, 100]; }; },
            { name = "C"; radius = 1.1; mass = 0.5; density = 2.0; } );
make = { method = "crm"; growth = 0.2; };
measure = { partials = { scale = "r"; step = 0.1; reach = [3.0]; }; };
save = true;
END
made() { run one one && awk -F'\t' '{ v[$1] = $2 } END {
    exit !((v["fraction"] - 0.55) ^ 2 < 1e-24 && v["min_gap"] > -1e-12 && v["number.A"] + v["number.B"] + v["number.C"] == 700) }' "$tmp/one/summary.tsv"; }
tell 'a pack of three kinds of sizes has its fraction' made
shares() { awk -F'\t' '{ v[$1] = $2 } END { a = v["volume.A"] - 2 / 3.25; b = v["volume.B"] - 1 / 3.25; c = v["volume.C"] - 0.25 / 3.25
    exit !(a * a < 2.5e-5 && b * b < 2.5e-5 && c * c < 2.5e-5) }' "$tmp/one/summary.tsv"; }
tell 'and the volumes that its masses and densities say' shares
told() { awk -F'\t' '{ v[$1] = $2 } END { exit !(v["size_number.A"] < 1.01 / v["number.A"] && v["size_number.B"] < 1.01 / v["number.B"] &&
    v["size_volume.B"] < 0.03 && v["size_volume.B"] > 0 && !("size_number.C" in v) && v["size_most.A"] <= 2.5 && v["size_least.B"] >= 0.5 &&
    v["size_most.B"] <= 1.5) }' "$tmp/one/summary.tsv"; }
tell 'how near they are to their laws is told' told
table() { awk -F'\t' '/^#/ || /^species/ { next } { n[$1]++; if ($1 == 2 && $2 > 0.7501 && $2 < 0.9999) empty++
    if (($3 - $4) ^ 2 > 1e-3 || ($5 - $6) ^ 2 > 1e-3) far++; if ($1 == s && $2 < a) falls++; s = $1; a = $2; last[$1] = $3 * $5 }
    END { exit !(n[1] == 100 && n[2] == 100 && !n[3] && empty <= 1 && !far && !falls && (last[1] - 1) ^ 2 < 1e-20 && (last[2] - 1) ^ 2 < 1e-20) }' \
    "$tmp/one/sizes.tsv"; }
tell 'a table has the shares, and at most the radius of one stratum in an empty class' table
read_again() { ends 0 "$randpack" measure "$tmp"/one/pack-{0,1}.xyz --scene "$tmp/one.scene" --out "$tmp/again" || return 1
  for q in number.A least_gap.A-B nearest.B-C min_gap; do
    awk -v a="$(value $q "$tmp/one")" -v b="$(value $q "$tmp/again")" \
      'BEGIN { exit !(a != "" && (a - b) ^ 2 < 1e-8 * (a * a + 1e-6)) }' || { echo "$q differs"; return 1; }
  done; }
tell 'the files of the packs have the radii' read_again
radii() { awk 'NR > 2 { print $1, $5 }' "$tmp/$1" | sort; }
same_radii() { run one points --set 'make={method="points";}' --set 'measure={rdf={};}' &&
  run one rsa --set 'make={method="rsa";order="large first";}' --set fraction=0.3 --set 'measure={rdf={reach=3.0;}}' &&
  cmp -s <(radii points/pack-0.xyz) <(radii points/pack-1.xyz) && cmp -s <(radii points/pack-0.xyz) <(radii rsa/pack-0.xyz); }
tell 'every method and every pack has the same radii' same_radii
law() { awk '$1 == "A" && $5 > m { m = $5 } END { print m }' "$tmp/points/pack-0.xyz" > "$tmp/most"
  awk -F'\t' -v m="$(cat "$tmp/most")" '{ v[$1] = $2 } END { exit !((v["reduced_density"] - 0.55) ^ 2 < 1e-24 && (m / 2 - v["size_most.A"]) ^ 2 < 1e-10) }' \
    "$tmp/points/summary.tsv"; }
tell 'which are those of the law, and add up to the fraction' law
counts() { sed 's/number = 700; //; s/mass = [0-9.]*; density = [0-9.]*;/number = 50;/' "$tmp/one.scene" > "$tmp/few.scene"
  run few few && [ "$(value number.A "$tmp/few")" = 50 ] && [ "$(value number.B "$tmp/few")" = 50 ]; }
tell 'or the numbers are given' counts
plan() { ends 0 "$randpack" plan "$tmp/one.scene" && grep -q '34 bytes' "$tmp/out" && grep -q ' sizes.tsv' "$tmp/out" && grep -q '^modules.* sizes ' "$tmp/out"; }
tell 'the plan tells of it' plan

# A species as a list, in the scene or in a file, in any order: these particles and no others.
printf '# beads\rdiameter, count\r4, 10\r3;25 # small\r\r4 5\r' > "$tmp/beads.txt"
cat > "$tmp/list.scene" <<'END'
dimension = 3; fraction = 0.3; save = true; make = { method = "rsa"; order = "large first"; };
species = ( { name = "D"; sizes = { law = "list"; radii = [2, 1.5, 2.0]; counts = [10, 25, 5]; }; }, { name = "E"; radius = 1; number = 7; } );
measure = { rdf = { reach = 2.0; }; };
END
listed() { run list list "$@" && diff <(radii list/pack-0.xyz | uniq -c | tr -s ' ') <(printf ' 25 D 1.5\n 15 D 2\n 7 E 1\n') && [ "$(value fraction "$tmp/list")" = 0.3 ]; }
tell 'a species is a list of radii and counts' listed
tell 'or a file of diameters and counts' listed --set "species.[0].sizes={law=\"list\";file=\"$tmp/beads.txt\";}"
doubled() { run list list --set number=80 --set 'species=({name="D";share=1.0;sizes={law="list";radii=[2,1.5];counts=[15,25];};})' &&
  diff <(radii list/pack-0.xyz | uniq -c | tr -s ' ') <(printf ' 50 D 1.5\n 30 D 2\n'); }
tell 'or a law, of which more are made' doubled
printf 'radius 1\n' > "$tmp/radii.txt"
tell 'a file that speaks of radii' refused 'radii.txt:1: not a diameter and a number of particles; ' "$randpack" run "$tmp/list.scene" --set "species.[0].sizes={law=\"list\";file=\"$tmp/radii.txt\";}"

# The number from side, box and fraction: the side stays, and the fraction is that of the nearest whole number.
cat > "$tmp/side.scene" <<'END'
dimension = 3; side = 200; box = [200, 250.0, 200]; fraction = 0.5; save = true; measure = { rdf = { step = 1; reach = 3.0; }; };
species = ( { name = "ball"; radius = 12.0; } ); make = { method = "crm"; growth = 0.5; };
END
by_side() { run side side && [ "$(value number "$tmp/side")" = 691 ] && awk -F'[" ]' 'NR == 2 { for (k = 2; k <= 10; k += 4) bad += ($k / (k == 6 ? 250 : 200) - 1) ^ 2 > 1e-28
    exit !!bad }' "$tmp/side/pack-0.xyz" &&
  awk -v f="$(value fraction "$tmp/side")" 'BEGIN { exit !((f - 691 * 4 / 3 * 3.14159265358979 * 12 ^ 3 / 1e7) ^ 2 < 1e-22) }'; }
tell 'side, box and fraction give the number' by_side
mixed_side() { run side side --set 'species=({name="L";radius=12;volume=1;},{name="S";radius=6;volume=1;})' --set fraction=0.3 && [ "$(value number "$tmp/side")" = 1865 ]; }
tell 'of shares of the volume, too' mixed_side
exit $failed
