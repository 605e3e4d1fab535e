#!/bin/bash
# tests/check-scenes.sh: every wrong scene, setting, option and pack is refused in one line that says
# where, what, and what would be right; status 2; nothing written.
. tests/tell.sh
shopt -s nullglob

# Each scene of tests/bad says itself what is expected: # expect LINE: WORDS.
bad_scene() {
  local scene=$1 expect line words
  expect=$(sed -n 's/^# expect //p' "$scene")
  line=${expect%%:*} words=${expect#*: }
  [ -n "$words" ] && [ "${words#*;}" != "$words" ] || { echo "no expectation"; return 1; }
  refused "$scene:$line: $words" "$randpack" run "$scene" --out "$tmp/new" && [ ! -e "$tmp/new" ] &&
    refused "$scene:$line: $words" "$randpack" plan "$scene"
}
scenes=(tests/bad/*.scene)
tell 'there are at least thirteen wrong scenes' test ${#scenes[@]} -ge 13
for scene in "${scenes[@]}"; do
  name=${scene##*/}
  tell "scene ${name%.scene}" bad_scene "$scene"
done
mkdir "$tmp/folder" && : > "$tmp/empty.scene" && printf '\0\377\001' > "$tmp/binary.scene"
tell 'an empty scene' refused "$tmp/empty.scene:1: dimension is missing" "$randpack" run "$tmp/empty.scene"
tell 'a scene that is not there' refused "$tmp/no.scene: cannot be read; give" "$randpack" run "$tmp/no.scene"
tell 'a directory as a scene' refused "$tmp/folder: cannot be read; give" "$randpack" run "$tmp/folder"
printf '\357\273\277dimension = 3;\nspecis = 2;\n' > "$tmp/mark.scene"
tell 'a scene behind a byte order mark' refused "$tmp/mark.scene:2: specis is not a key of a scene; known" "$randpack" run "$tmp/mark.scene"
tell 'a scene that is no text' refused "$tmp/binary.scene:1: " "$randpack" run "$tmp/binary.scene"

# The scenes of the book, and how a draft and `make check` shorten them, are all right.
reads() ( # a shell of its own: brackets in a setting are no pattern
  status=0 scenes=(figures/*/*.scene examples/*.scene)
  set -f
  for scene in "${scenes[@]}"; do
    small=$(sed -n 's/^# small: *//p' "$scene")
    # shellcheck disable=SC2046,SC2086
    "$randpack" plan "$scene" > "$tmp/plan" && "$randpack" plan "$scene" $(paper/few "$scene" 2) > "$tmp/plan" &&
      "$randpack" plan "$scene" $small > "$tmp/plan" || { echo "$scene"; status=1; }
  done
  exit $status
)
tell 'the scenes of the book are read, as a draft and a test shorten them too' reads

# Settings from the command line, between bars: the setting, the words of the answer.
good=$tmp/good.scene
cat > "$good" <<'END'
dimension = 2;
species   = ( { radius = 1.0; number = 100; } );
fraction  = 0.3;
make      = { method = "rsa"; };
measure   = { rdf = { reach = 4.0; }; };
END
while IFS='|' read -r setting words; do
  tell "--set $setting" refused "$words" "$randpack" plan "$good" --set "$setting"
done <<'END'
foo|--set foo: not a setting; give KEY=VALUE
=5|--set =5: not a setting; give KEY=VALUE
fractoin=0.2|:--set: fractoin is not a key of a scene; known here:
fraction=1.2|:--set: fraction has a wrong value; give a number above 0
fraction=|:--set: fraction has a wrong value; give a number above 0
fraction=0.2; gap=1|:--set: fraction has a wrong value; give a number above 0
fraction.x=3|--set fraction.x: no such place in
fraction=max|:--set: the number of particles at saturation is not known in advance; give side
realizations=2.5|:--set: realizations has a wrong value; give a whole number
seed=-1|:--set: seed has a wrong value; give a whole number
species=5|:--set: species has a wrong value; give a list
species.[0].radius=nan|:--set: radius has a wrong value; give a number above 0
species.[0].shape=round|:--set: shape has a wrong value; give a group
species.[0].shape={kind="polygon";sides=2;}|:--set: sides has a wrong value; give the number of sides of a regular polygon
species.[0].shape={kind="polygon";sides=5;}|good.scene:4: rsa makes balls, but a species has a shape; give one of
make.method=pour|:--set: method has a wrong value; give one of
measure.rdf.step=0|:--set: step has a wrong value; give the width
measure.rdf.reach=99|measure.rdf.reach = 99 goes beyond half the box; the largest reach here is 16.18
measure.contact.step=30|goes beyond half the box; the largest reach here is 16.18
measure.histogram={radius=17.0;}|measure.histogram.radius = 17 goes beyond half the box; the largest
measure.order.cut=1e9|:--set: cut has a wrong value; give the longest
measure.nearest.reach=1e9|step and reach of measure.nearest make 5e+10 bins; give
measure.K={step=5.0;reach=2.0;}|step and reach of measure.K make 0 bins; give
measure.quotients.steps=[3.0]|steps of measure.quotients contain 3; give
END

# Options and words.
while IFS='|' read -r line words; do
  read -ra given <<< "${line//SCENE/$good}"
  tell "randpack $line" refused "$words" "$randpack" "${given[@]}"
done <<'END'
fly|fly: no such verb; see
run|run needs one scene; see
run SCENE SCENE|run needs one scene; see
plan|plan needs one scene; see
run SCENE --threads 0|--threads 0: give a whole number from 1
run SCENE --threads two|--threads two: give a whole number from 1
run SCENE --threads 2x|--threads 2x: give a whole number from 1
run SCENE --threads|--threads: no such option, or its value is missing; see
run SCENE --fast|--fast: no such option, or its value is missing; see
run SCENE -t 2|-t: no such option, or its value is missing; see
measure|measure needs PACK.xyz --scene SCENE
measure pack.xyz|measure needs PACK.xyz --scene SCENE
theory|theory : no such curve; see
theory percus --phi 0.3 --at 2|theory percus: no such curve; see
theory py --at 2|--phi (missing): give numbers from
theory py --phi 0.3|--at (missing): give numbers from
theory py --phi x --at 2|--phi x: give numbers from
theory py --phi 0.8 --at 2|--phi 0.8: give numbers from
theory py --phi 0 --at 2|--phi 0: give numbers from
theory py --phi 0.3 --at 2,,3|--at 2,,3: give numbers from 0
theory py --phi 0.3 --at nan|--at nan: give numbers from 0
theory py --phi 0.3 --at 2;3|--at 2;3: give numbers from 0
theory contact --phi 0.3 --at 2|--at is not an option of theory contact; leave
theory structure --phi 0.3 --at 2|--at is not an option of theory structure; leave
END
for width in nonsense '' AVX2; do
  tell "RANDPACK_SIMD='$width'" refused 'RANDPACK_SIMD must be default, avx2 or avx512f' \
    env RANDPACK_SIMD="$width" "$randpack" run "$good" --out "$tmp/new"
done
tell 'nothing was written' test ! -e "$tmp/new"
exit $failed
