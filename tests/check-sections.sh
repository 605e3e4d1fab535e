#!/bin/bash
# tests/check-sections.sh: plane sections in a scene, of packs in space and of a micrograph in a file.
. tests/tell.sh
near() { awk -v x="$1" -v y="$2" -v e="$3" 'BEGIN { exit !(x != "" && (x - y) ^ 2 <= e * e) }' || { echo "$1 is not $2"; return 1; }; }
# A cube of side 4 with one sphere of radius 1: half of the planes cut it.
cat > "$tmp/one.scene" <<'END'
dimension = 3; seed = 5; realizations = 2; fraction = 0.0654498469497873;
species = ( { name = "A"; radius = 1.0; number = 1; } );
make = { method = "rsa"; };
measure = { sections = { planes = 1000; reach = 2.0; width = 0.125; }; };
END
one() { ends 0 "$randpack" run "$tmp/one.scene" --out "$tmp/one" &&
  near "$(value section_area "$tmp/one")" 0.0654498 1e-5 && near "$(value section_radius "$tmp/one")" 1 0.002 &&
  near "$(value section_number "$tmp/one")" 0.015625 5e-5 && near "$(value sphere_number "$tmp/one")" 0.015625 0; }
tell 'one sphere, cut a thousand times' one
# The unit of length is that of the scene, whatever the box is.
unit() { ends 0 "$randpack" run "$tmp/one.scene" --set 'species.[0].radius=2.0' --out "$tmp/two" &&
  near "$(value section_number "$tmp/two")" "$(value section_number "$tmp/one")" 1e-12 &&
  near "$(value section_radius "$tmp/two")" "$(value section_radius "$tmp/one")" 1e-12; }
tell 'and in another unit of length' unit
# A micrograph: the discs of equal spheres of radius 1 at heights (i + 1/2) / 20, in a file.
{ echo 20; echo 'Lattice="10 0 0 0 10 0 0 0 1" Properties=species:S:1:pos:R:2:radius:R:1 pbc="T T F"'
  awk 'BEGIN { for (i = 0; i < 20; i++) printf "d %g %g %.12g\n", 1 + 2 * (i % 5), 1 + 2.2 * int(i / 5), sqrt(1 - ((i + 0.5) / 20) ^ 2) }'; } > "$tmp/photo.xyz"
printf 'dimension = 2; unit = 1.0; measure = { sections = { width = 0.25; reach = 3.0; }; };\n' > "$tmp/photo.scene"
photo() { ends 0 "$randpack" measure "$tmp/photo.xyz" --scene "$tmp/photo.scene" --out "$tmp/photo" && near "$(value section_radius "$tmp/photo")" 1 0.06 &&
  near "$(value section_number "$tmp/photo")" 0.1 0.01 && [ -z "$(value sphere_number "$tmp/photo")" ]; }
tell 'a micrograph from a file' photo
turned() { { head -n 2 "$tmp/photo.xyz"; tail -n +3 "$tmp/photo.xyz" | tac; } > "$tmp/turned.xyz" &&
  ends 0 "$randpack" measure "$tmp/turned.xyz" --scene "$tmp/photo.scene" --out "$tmp/turned" && diff -r "$tmp/photo" "$tmp/turned"; }
tell 'and its discs in another order' turned
overlap() { refused 'sections needs balls or discs that do not overlap' "$randpack" run "$tmp/one.scene" --set 'make.method="points"' --out "$tmp/none"; }
tell 'overlapping spheres, whose discs would be one, are refused' overlap
none() { ends 1 "$randpack" run "$tmp/one.scene" --set fraction=1e-6 --set measure.sections.planes=1 --out "$tmp/none" &&
  grep -q 'no plane meets a sphere; give more measure.sections.planes' "$tmp/err"; }
tell 'no disc at all is said' none
narrow() { ends 1 "$randpack" run "$tmp/one.scene" --set measure.sections.width=1e-4 --out "$tmp/none" && grep -q 'give at least 0.0005' "$tmp/err"; }
tell 'classes too narrow are refused, with the width' narrow
exit $failed
