#!/usr/bin/env bash
# Remarks without points: who passes is told of what is set in vain and made anew in each frame; nobody else is.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

# Work in vain, in a lab that is right: a uniform that no shader needs, and a texture a frame.
waste() {
    sed -i 's/^uniform mat4 u_light_clip_from_world;/&\nuniform float u_bias_unused;/' "$1"/03-*/shadow.frag
    sed -i 's/^    frame_bind(frame);/&\n    program_set_float(program, "u_bias_unused", 1);/' "$1"/03-*/lab.c
    sed -i 's/^    frame_bind(frame);/&\n    GLuint spare;\n    glGenTextures(1, \&spare);\n    glDeleteTextures(1, \&spare);/' \
        "$1"/03-*/lab.c
}

folder=$(solved plain)
grades --trusted --lab 03 --seed 1 "$folder"
expect "the solution passes" 0 "100.00 of 100 points"
[[ $out != *"without points"* ]] && ok || bad "the solution gets no remark" "$out"

folder=$(solved waste)
waste "$folder"
grades --trusted --lab 03 --seed 1 "$folder"
expect "what is in vain is told, and costs nothing" 0 "100.00 of 100 points" \
    "without points: the uniform u_bias_unused is set, but has no effect" \
    "without points: each frame makes a texture anew (glGenTextures)"

# What is left of the frame before: the light where the sky is now; a lab without it is told nothing (above).
for change in '07 /glClearBufferfv(GL_COLOR, 1/d' '10 s/GL_COLOR_BUFFER_BIT | GL_DEPTH/GL_DEPTH/'; do
    lab=${change%% *} folder=$(solved "left-${change%% *}" "${change%% *}")
    sed -i "${change#* }" "$folder/$lab"-*/lab.c
    grades --trusted --lab "$lab" --seed 1 "$folder"
    expect "lab $lab: a frame hangs on the frame before it" 0 "100.00 of 100 points" "without points: a frame hangs on the frame before it"
done

# A second frame that crashes is told, too, and nothing more is made of it.
folder=$(solved crashes)
sed -i 's/^static bool create(const Frame \*frame) {/static int frames;\n&\n    frames = 0;/; s/^    frame_bind(frame);/    if (frames++)\n        *(volatile int *)0 = 1;\n&/' \
    "$folder"/03-*/lab.c
grades --trusted --lab 03 --seed 1 "$folder"
expect "a second frame that crashes" 0 "100.00 of 100 points" "without points: the camera was turned, and no second frame came"
[[ $out != *AddressSanitizer* && $out != *"it crashed"* ]] && ok || bad "a lab that passes is not explained" "$out"

# Our labs draw any frame in the same way.
grades --trusted --seed 1 solutions
expect "all labs" 0 "1600.00 of 1600 points"
[[ $out != *"without points"* ]] && ok || bad "a solution gets no remark" "$out"

# Made in create, or in the first frame alone, it is no work that is repeated.
folder=$(solved once)
sed -i 's/^    frame_bind(frame);/&\n    static GLuint once;\n    if (!once)\n        glGenTextures(1, \&once);/' "$folder"/03-*/lab.c
grades --trusted --lab 03 --seed 1 "$folder"
expect "once is enough" 0 "100.00 of 100 points"
[[ $out != *"without points"* ]] && ok || bad "what is made once gets no remark" "$out"

folder=$(solved wrong)
waste "$folder"
sed -i 's/depth < position_map\.z/depth > position_map.z/' "$folder"/03-*/shadow.frag
grades --trusted --lab 03 --seed 1 "$folder"
expect "a lab that is wrong has other cares" 1 "3.5"
[[ $out != *"without points"* ]] && ok || bad "a lab that is wrong gets no remark" "$out"
finish
