#!/bin/bash
# tests/check-voids.sh: pores, surfaces and clusters in a scene: what the tables hold, and in which units.
. tests/tell.sh
run() { ends 0 "$randpack" run "$tmp/$1.scene" --out "$tmp/$2" "${@:3}"; } # run SCENE DIR SETTING...
at() { awk -F'\t' -v R="$2" '$1 != "R" && !/^#/ && ($1 - R) ^ 2 < 1e-18 { print $2 }' "$tmp/$1.tsv"; } # at DIR/TABLE R
e() { awk -v OFMT=%.15g "BEGIN { pi = atan2(0, -1); print $1 }"; }
near() { awk -v x="$1" -v y="$2" -v e="$3" 'BEGIN { exit !(x != "" && (x - y) ^ 2 <= e * e) }' || { echo "$1 is not $2"; return 1; }; }
# One disc of radius 2 in a square of area 200 pi: phi is .02.
cat > "$tmp/one.scene" <<'END'
dimension = 2; seed = 5; realizations = 2; fraction = 0.02;
species = ( { name = "D"; radius = 2.0; number = 1; } );
make = { method = "points"; };
measure = { pores = { step = 0.25; reach = 2.0; inside = 0.5; }; surface = { step = 0.5; reach = 3.0; points = 3000.0; };
            cluster = { step = 0.5; reach = 3.0; }; };
END
tell 'one disc has its pores, surfaces and cluster' run one one
free() { near "$(at one/E_V 0.5)" "$(e '1 - 0.02 * 1.5 ^ 2')" 1e-12; }
tell 'the share that is free beyond R = .5' free
inside() { near "$(at one/E_V -0.5)" "$(e '1 - 0.02 * 0.5 ^ 2')" 1e-12; }
tell 'the table begins inside the disc' inside
density() { near "$(at one/H_V 0.375)" "$(e '0.02 * (1.5 ^ 2 - 1.25 ^ 2) / 0.25')" 1e-12; }
tell 'its density, a mean over a bin' density
pores() { near "$(at one/pores 0.125)" "$(e '0.02 * (1.25 ^ 2 - 1) / 0.25 / 0.98')" 1e-12 && [ "$(awk '!/^#/' "$tmp/one/pores.tsv" | wc -l)" = 9 ]; }
tell 'the density of pores is of the matrix, and begins at the surface' pores
steps() { run one coarse --set measure.pores.step=3.0 --set measure.pores.reach=3.0 --set measure.pores.inside=0.0 &&
  run one narrow --set measure.pores.step=0.01 && [ "$(value pore_mean "$tmp/coarse")" = "$(value pore_mean "$tmp/narrow")" ] &&
  [ "$(value pore_second "$tmp/coarse")" = "$(value pore_second "$tmp/one")" ]; }
tell 'the moments of pores do not depend on the step of the tables' steps
centre() { near "$(at one/E_P 2)" 1 0 && near "$(value centre_gap "$tmp/one")" "$(e 'sqrt(50 * pi) - 1')" 1e-9; }
tell 'the nearest surface of its centre is that of its image' centre
sampled() { run one sampled --set measure.pores.method='"sampled"' --set measure.pores.points=200000 &&
  near "$(at sampled/E_V 0.5)" "$(at one/E_V 0.5)" 0.002 &&
  near "$(value pore_mean "$tmp/sampled")" "$(value pore_mean "$tmp/one")" 0.05 &&
  near "$(value pore_second "$tmp/sampled")" "$(value pore_second "$tmp/one")" 0.4; }
tell 'by points the same but for their error' sampled
# s is 4 pi / (200 pi), in 1/a 0.04.
surfaces() { near "$(value specific_surface "$tmp/one")" 0.04 1e-12 && near "$(at one/F_sv 0)" 0.02 1e-12 &&
  near "$(at one/F_sv 2)" 0.04 1e-12 && near "$(at one/F_sv 1)" "$(e '0.04 * 2 / 3')" 0.0008; }
tell 'surface and matrix, in units of the radius' surfaces
rest() { near "$(at one/F_sp 1)" "$(e "0.04 - $(at one/F_sv 1)")" 1e-12; }
tell 'surface and particle are the rest' rest
# Within R = 1.5 of a point of the circle are 4 arcsin .75 of its 2 pi radii, within 1 a third; by area of the ring.
pairs() { near "$(at one/F_ss 1.25)" "$(e '0.04 * (4 * atan2(0.75, sqrt(1 - 0.75 ^ 2)) - 2 * pi / 3) / (pi * 1.25)')" 0.0005; }
tell 'surface and surface, in units of the radius' pairs
alone() { near "$(value alone "$tmp/one")" 1 0 && near "$(at one/C2 0)" 0.02 1e-12 && near "$(at one/C2 2)" 0 0 &&
  near "$(at one/C2 1)" "$(e '0.02 * (2 * pi / 3 - sqrt(3) / 2) / pi')" 1e-12; }
tell 'the cluster of one disc' alone
shapes() { run one shapes --set 'species.[0].shape={kind="superellipse"; aspect=50.0; m=1.0;}' --set measure.pores.points=1e6 &&
  [ "$(value alone "$tmp/shapes")" = 1 ] && near "$(at shapes/C2 0)" 0.02 1e-12; }
tell 'a needle is sampled, without being asked' shapes
# In a small box the first bins hold a few vectors, of which one mean is the largest by chance.
cat > "$tmp/small.scene" <<'END'
dimension = 3; seed = 1; realizations = 1; fraction = 0.2;
species = ( { radius = 1.0; number = 20; } );
make = { method = "rsa"; };
measure = { structure = { reach = 4.0; }; };
END
few() { run small small && awk -F'\t' -v told="$(value highest_S "$tmp/small")" -v ka="$(value highest_ka "$tmp/small")" '
  !/^#/ && $1 != "ka" { most = $2 > most ? $2 : most; found += $1 == ka && $2 == told } END { exit !(found && most > told) }' "$tmp/small/structure.tsv"; }
tell 'the highest S is of a bin with vectors enough' few
# S(k) of the core of a file without a box, beside that of the box that it was cut from: 4 errors, half a bin to either side.
cat > "$tmp/whole.scene" <<'END'
dimension = 3; seed = 3; realizations = 1; fraction = 0.3; save = true;
species = ( { name = "A"; radius = 1.0; number = 3000; } );
make = { method = "rsa"; };
measure = { structure = { reach = 10.0; step = 0.5; vectors = 4000.0; }; };
END
echo 'dimension = 3; inside = 0.95; measure = { structure = { reach = 10.0; step = 0.5; vectors = 4000.0; }; };' > "$tmp/core.scene"
core() { run whole whole && sed '2s/Lattice="[^"]*" *//; 2s/pbc="[^"]*" *//' "$tmp/whole/pack-0.xyz" > "$tmp/core.xyz" &&
  ends 0 "$randpack" measure "$tmp/core.xyz" --scene "$tmp/core.scene" --out "$tmp/core" &&
  awk -F'\t' '/^#/ || $1 == "ka" { next } { b = int($1 / 0.5) } NR == FNR { S[b] = $2; e[b] = $3; next }
    { n++; off = ($2 - S[b]) / sqrt($3 ^ 2 + e[b] ^ 2); sum += off ^ 2; wide += ($3 / e[b] > 1.9); if (off ^ 2 > 16) exit bad = 1 }
    END { exit !(!bad && n == 20 && sum / n < 2 && wide == n) }' "$tmp/whole/structure.tsv" "$tmp/core/structure.tsv"; }
tell 'a core has the S(k) of the pack that it was cut from, with larger errors' core
heap() { sed 's/^fraction.*//; s/fraction = 0.3; save = true;//; s/"rsa"/"gravity"/; s/3000/1500/' "$tmp/whole.scene" > "$tmp/heap.scene" && run heap heap &&
  awk -F'\t' -v first="$(awk -F'\t' '$1 !~ /^#|ka/ { print $1; exit }' "$tmp/heap/structure.tsv")" 'BEGIN { exit !(first > 0.4 && first < 2) }'; }
tell 'a heap has an S(k) from the first wave of its core on' heap
short() { ends 1 "$randpack" run "$tmp/heap.scene" --set measure.structure.reach=0.1 --set measure.structure.step=0.05 --out "$tmp/short" && [ ! -e "$tmp/short/structure.tsv" ]; }
tell 'a reach below the first wave of a core is not reached' short
exit $failed
