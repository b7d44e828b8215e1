#!/usr/bin/env bash
# What makes a check, and a lab, fail beside wrong pixels: a stage of another size, a refused call, a single failed check,
# what the driver does not survive.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
check() { field "[c for c in r[\"labs\"][0][\"checks\"] if c[\"name\"] == \"$1\"][0][\"$2\"]"; }

# A size that stands in the code.
fixed=$(solved fixed 03)
sed -i 's/state.size = (int)frame->knobs\[KNOB_MAP_SIZE\]/state.size = 333/' "$fixed"/03-*/lab.c
grades --lab 03 --seed 1 --format json "$fixed"
name="map pass at another map size"
[[ $status == 1 && $(check "$name" score) == 0.0 ]] && ok || bad "a map of another size gets nothing" "$out"
[[ $(check "$name" cause) == *'"shadow map" is 333 x 333, and here it has to be '* ]] && ok || bad "both sizes are named" "$out"

# A refused call in a frame that is right all the same; an unknown name, which does nothing anywhere.
refused=$(solved refused 03)
sed -i 's/^    frame_bind(frame);/    frame_bind(frame);\n    glViewport(0, 0, -1, -1);/' "$refused"/03-*/lab.c
grades --lab 03 --seed 1 --format json "$refused"
[[ $status == 1 && $(field 'r["score"]') == 52.5 ]] && ok || bad "a refused call halves the points" "$out"
[[ $(field 'r["labs"][0]["warnings"]') == *"GL_INVALID_VALUE in glViewport (lab.c:"* ]] && ok || bad "the refused call is named" "$out"
[[ $(check "the whole picture" cause) == *"OpenGL refused a call"* ]] && ok || bad "the cause is the call" "$out"
sed -i 's/glViewport(0, 0, -1, -1)/glEnable(GL_TEXTURE_2D)/' "$refused"/03-*/lab.c
grades --lab 03 --seed 1 --format json "$refused"
[[ $status == 0 && $(field 'r["score"]') == 100.0 ]] && ok || bad "an unknown name costs nothing" "$out"

# One check of 8 points that fails by a third: more than 95 points, and not passed.
single=$(solved single 03)
sed -i 's/^    if (position_map.z > 1.0)/    if (position_map.z > 1.0 \&\& fract(gl_FragCoord.x \/ 16.0) > 0.13)/' "$single"/03-*/shadow.frag
grades --lab 03 --seed 1 --format json "$single"
[[ $status == 1 && $(field 'r["score"] >= 95') == True && $(field 'r["labs"][0]["status"]') == failed ]] &&
    ok || bad "a lab with a failed check is not passed, whatever the points" "$(field 'r["score"], [(c["name"], c["score"]) for c in r["labs"][0]["checks"]]')"

# What is right in the first frame only: the light's matrix is made once and kept.
kept=$(solved kept 03)
sed -i 's/^static mat4s light_clip_from_world(const Light \*light) {/&\n    static mat4s kept;\n    if (kept.m33 != 0 || kept.m23 != 0)\n        return kept;/
    s/^    return \(glms_mat4_mul(clip_from_light, light_from_world)\);/    return kept = \1;/' "$kept"/03-*/lab.c
for search in "" --no-swap; do
    grades --lab 03 --seed 1 --trusted $search "$kept"
    expect "only the first frame is right, $search" 1 "it is right in the first frame, and wrong when another was drawn before"
done
grades --lab 03 --seed 1 --trusted "$single"
[[ $out != *"first frame"* ]] && ok || bad "wrong in each frame" "$out"

# The C part of lab 01 done before its shader: no uniform of a subroutine is there to be chosen.
early=$(solved early 01)
cp labs/01-subroutines/shade.frag "$early"/01-*/
grades --lab 01 --seed 1 --trusted "$early"
[[ $status == 1 && $out != *crashed* ]] && ok || bad "nothing to choose is no crash" "$out"

finish
