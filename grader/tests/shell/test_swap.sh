#!/usr/bin/env bash
# The part with the fault is found, in mistakes that no catalogue holds, with our solution and without; nothing of ours
# comes out.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

# resolve NAME LAB: a submission with the solution's halves only, so that edits meet each text once.
resolve() {
    local to=$work/$1 file
    mkdir -p "$to"
    cp -r "$root/solutions/$2"-* "$to"
    for file in "$to"/*/*.[cfgh]*; do
        awk '/^#ifdef SOLUTION/ { inside = 1; next } inside && /^#else/ { skip = 1; next }
             inside && /^#endif/ { inside = skip = 0; next } !skip' "$file" >"$file.new" && mv "$file.new" "$file"
    done
    echo "$to"/*
}
summary() { field '(r["labs"][0]["summary"] or {}).get("text", "")'; }

# found NAME LAB FILE SED FUNCTION
found() {
    local folder said
    folder=$(resolve "$1" "$2")
    sed -i "$4" "$folder/$3"
    grades --trusted --lab "$2" --seed 1 --format json "$folder"
    out=$(sed '1{/^grade:/d}' <<<"$out")
    said=$(summary)
    [[ $said == *"\`$5\` ($3)"*"pass"* ]] && ok || bad "$1: the fault is in $5" "$said"
    grades --no-swap --trusted --lab "$2" --seed 1 --format json "$folder"
    out=$(sed '1{/^grade:/d}' <<<"$out")
    said=$(summary)
    [[ $said == *"\`$5\` ($3)"*" as handed out, the rest draws as it should"* ]] && ok ||
        bad "$1: without our solution the fault is in $5" "$said"
}
found "half the field of view" 03 lab.c 's/light->fov_y/0.5f * light->fov_y/' light_clip_from_world
found "the depth is compared with its square" 03 shadow.frag 's/depth < position_map\.z/depth < position_map.z * position_map.z/' visibility
found "a cap is missing" 07 volume.geom 's/    emit(at_infinity(c));/    emit(here(c));/' emit_caps
found "no stencil test" 07 lab.c 's/    glEnable(GL_STENCIL_TEST);//' draw_volumes

# Other random numbers stand in a given line of a function whose task is right: the task that needs them is told.
folder=$(resolve noise 06)
sed -i 's/random_range(&random, -0.5f, 0.5f)/(float)rand() \/ (float)RAND_MAX - 0.5f/; /Random random = {PATTERN_SEED};/d' \
    "$folder/offsets.h"
grades --trusted --lab 06 --seed 1 "$folder"
expect "rand()" 1 "\`fill_offsets\` (offsets.h), task 6.3" "not the given random numbers"

# Of a function with several tasks only those are told in whose answers the student's reads otherwise; and no mistake
# is named whose words stand there as they should.
folder=$(resolve tasks 03)
sed -i 's/if (position_light_clip.w <= 0.0)/if (position_light_clip.z < 0.0)/' "$folder/shadow.frag"
grades --trusted --lab 03 --seed 1 "$folder"
expect "the task in the function" 1 "\`visibility\` (shadow.frag), task 3.7:"
folder=$(resolve words 07)
sed -i 's/    glDisable(GL_CULL_FACE);/&\n    glDisable(GL_DEPTH_TEST);/' "$folder/lab.c"
grades --trusted --lab 07 --seed 1 "$folder"
expect "no mistake is named whose words are right" 1 "=> the fault is in \`draw_volumes\` (lab.c), task 7.6"

# Two faults in two functions; a task that is not done is no fault.
folder=$(resolve two 07)
sed -i 's/    emit(at_infinity(c));/    emit(here(c));/' "$folder/volume.geom"
sed -i 's/    glEnable(GL_STENCIL_TEST);//' "$folder/lab.c"
grades --trusted --lab 07 --seed 1 "$folder"
expect "two faults" 1 "\`emit_caps\` (volume.geom)" "\`draw_volumes\` (lab.c)"
# Two functions of one file, of which neither helps alone: not the whole file.
folder=$(resolve together 04)
sed -i 's/        glCullFace(GL_FRONT);/        UNUSED(method);/; s/    frame_bind(frame);/&\n    if (frame->knobs[KNOB_METHOD] == METHOD_FRONT_FACES)\n        glCullFace(GL_FRONT);/' \
    "$folder/lab.c"
grades --trusted --lab 04 --seed 1 "$folder"
expect "two functions together" 1 "there are faults in \`draw_map\` (lab.c) and in \`draw_picture\` (lab.c), task 4.4"

# A function of the student's own stands for ours that she has not got, with its tasks.
folder=$(resolve helper 03)
sed -i 's/float visibility(vec3 position_world) {/float light_at(vec4 position_light_clip) {/; /vec4 position_light_clip = u_light/d
    /position_light_clip.w <= 0.0/,+1d; s/= visibility(v_position_world)/= light_at(u_light_clip_from_world * vec4(v_position_world, 1.0))/' \
    "$folder/shadow.frag"
grades --trusted --lab 03 --seed 1 "$folder"
expect "the task of a helper" 1 "\`main\` (shadow.frag) or in what it calls (light_at), task 3.7"
"$BUILD/skeletons" "$work/upto" 3.5 >/dev/null
grades --lab 03 --seed 1 "$work/upto"
expect "an open task is no fault" 1 "=> task 3.6 is next: it is not done"
[[ $out != *"the fault is"* ]] && ok || bad "no fault where a task is open" "$out"

# A student who leaves a TODO above her code has done the task, or has no effect yet; as handed out it is not done.
for search in "" --no-swap; do
    folder=$(resolve left 03)
    sed -i 's|^    return texture(u_shadow_map|    // TODO(3.5), second part: read\n&|; s|^    float depth = |    // TODO(3.5), second part: read\n&|
        s|    if (position_map.z > 1.0)|    // TODO(3.8): a point beyond the far plane\n    if (position_map.z > 1e9)|' "$folder/shadow.frag"
    grades --trusted $search --lab 03 --seed 1 "$folder"
    expect "code below a TODO $search" 1 "=> task 3.8 has no effect yet; the fault is in \`visibility\` (shadow.frag)"
    [[ $out != *"not done"* ]] && ok || bad "what is written is not called not done $search" "$out"
    sed -i '/    if (position_map.z > 1e9)/,+1d' "$folder/shadow.frag"
    grades --trusted $search --lab 03 --seed 1 "$folder"
    expect "nothing below a TODO $search" 1 "=> task 3.8 is next: it is not done"
done
# Where she took the other TODOs away, ours tells whose code it is; without it both are possible.
folder=$(resolve lone 03)
sed -i 's|    if (position_map.z > 1.0)|    // TODO(3.8): a point beyond the far plane\n    if (position_map.z > 1e9)|' "$folder/shadow.frag"
grades --trusted --lab 03 --seed 1 "$folder"
expect "a lone TODO" 1 "=> task 3.8 has no effect yet; the fault is in \`visibility\` (shadow.frag)"
grades --trusted --no-swap --lab 03 --seed 1 "$folder"
expect "a lone TODO without our solution" 1 "3.8 has no effect yet"

# In the jail the same is found; without the search the tasks are told; nothing that ours print comes out.
folder=$(resolve jail 07)
sed -i 's/    glEnable(GL_STENCIL_TEST);//' "$folder/lab.c"
grades --lab 07 --seed 1 "$folder"
expect "in the jail" 1 "\`draw_volumes\` (lab.c)"
grades --no-swap --lab 07 --seed 1 "$folder"
expect "--no-swap" 1 "\`draw_volumes\` (lab.c)" "as handed out, the rest draws as it should"
[[ $out != *"with ours"* ]] && ok || bad "--no-swap puts nothing of ours into the submission" "$out"

# Two faults in two functions that show in different checks.
folder=$(resolve both 05)
sed -i 's/xy + vec2(x, y) \* texel)/xy + 1.7 * vec2(x, y) * texel)/; s/f = place - corner/f = 0.5 * (place - corner)/' "$folder/shadow.frag"
grades --no-swap --lab 05 --seed 1 --trusted "$folder"
expect "two faults without our solution" 1 "there are faults in \`by_hand\` (shadow.frag) and in \`gather\` (shadow.frag)"

# Without our solution two tasks that draw the same are both told; so is the task of what else looks like "no effect".
folder=$(resolve fetch 08)
sed -i 's/texture(u_baked, texel .*)).r;/texelFetch(u_baked, ivec2(texel), 0).r;/' "$folder/occlusion.frag"
grades --no-swap --lab 08 --seed 1 --trusted "$folder"
expect "one picture of two tasks" 1 "\`bake\` (lab.c) or in \`baked_visibility\` (occlusion.frag), tasks 8.1 and 8.3"
folder=$(resolve colours 07)
sed -i 's/glDrawBuffers(2, /glDrawBuffers(1, /' "$folder/lab.c"
grades --no-swap --lab 07 --seed 1 --trusted "$folder"
expect "no effect of another task" 1 "tasks 7.2 and 7.1: with any of them" "only the first of the two colours is drawn to"
# What is done does too much: no check needs its task.
folder=$(resolve much 04)
sed -i 's/^    if (u_method == NORMAL_OFFSET) {/    if (u_method >= SLOPE) {/' "$folder/shadow.frag"
grades --no-swap --lab 04 --seed 1 --trusted "$folder"
expect "what is done for too many" 1 "\`lookup_position\` (shadow.frag), task 4.5"
finish
