#!/usr/bin/env bash
# A lab gets only what labs before it have built (common/GIVEN): its own answers are neither included nor found nor
# exported, whichever way they are asked for, and score nothing.
set -u
source "$(dirname "$0")/../helpers/lib.sh"

# refused NAME LAB PATTERN...: the submission of $work/NAME gets 0 on every check, and the grader says this.
refused() {
    local name=$1 lab=$2
    shift 2
    grades --lab "$lab" --seed 1 "$work/$name"
    expect "$name" 1 "$@" "0.00 of 100 points"
    grep -q '^  ok' <<<"$out" && bad "$name: a check has passed" "$out" || ok
}

# edit NAME LAB FILE SED: a solved lab with this edit.
edit() {
    solved "$1" "$2" >/dev/null
    sed -i "$4" "$work/$1"/*/"$3"
}
before() { echo "s|^#include \"lab.h\"|&\n$1|"; } # LINE: put behind the include of lab.h
in_create() { echo "/^static bool create(/a $1"; }

edit include-map 03 lab.c "$(before '#include "shadow_map.h"')"
refused include-map 03 'error: #error "shadow_map.h is given from lab 04 on'
edit include-map-path 03 lab.c "$(before '#include "scene/ray.h"')"
refused include-map-path 03 'error: #error "scene/ray.h is given from lab 08 on'

edit declare-map 03 lab.c "$(before 'typedef struct { GLuint a, b; int c; } Map; bool shadow_map_create(Map *, int, GLenum);'); $(in_create 'shadow_map_create(\&(Map){0}, 64, GL_DEPTH_COMPONENT24);')"
refused declare-map 03 "lab.c uses shadow_map_create, which is given from lab 04 on"
edit matrix 03 lab.c "$(before 'mat4s shadow_map_clip_from_world(const Light *);'); s|^static mat4s light_clip_from_world(const Light \*light) {|&\n    return shadow_map_clip_from_world(light);|"
refused matrix 03 "lab.c uses shadow_map_clip_from_world, which is given from lab 04 on"
edit asm-label 03 lab.c "$(before 'bool mine(void *, int, GLenum) __asm__("shadow_map_create");'); $(in_create 'mine(0, 64, GL_DEPTH_COMPONENT24);')"
refused asm-label 03 "lab.c uses shadow_map_create, which is given from lab 04 on"
edit rays 03 lab.c "$(before 'bool ray_hits(const Scene *, vec3s, vec3s, float);'); $(in_create 'ray_hits(frame->scene, vec3_make(0, 0, 0), vec3_make(0, 1, 0), 1);')"
refused rays 03 "lab.c uses ray_hits, which is given from lab 08 on"

# Lab 09 has to write what lab 07 was given.
edit silhouettes 09 lab.c "$(before '#include "scene/silhouette.h"')"
refused silhouettes 09 'error: #error "scene/silhouette.h is given from lab 10 on'
edit volumes 09 lab.c "$(before 'void casters_draw_volumes(const Frame *);'); s|^static void draw_light(const Frame \*frame) {|&\n    casters_draw_volumes(frame);|"
refused volumes 09 "lab.c uses casters_draw_volumes, which is given from lab 10 on"
edit volumes-later 10 lab.c "$(before '#include "scene/silhouette.h"'); $(in_create 'silhouette_destroy(\&(Volume){0});')"
grades --lab 10 --seed 1 "$work/volumes-later"
expect "silhouettes after lab 09" 0 "100.00 of 100 points"

edit include-glsl 03 shadow.frag 's|^#include "lighting.glsl"|&\n#include "shadow_map.glsl"|'
refused include-glsl 03 "shadow_map.glsl:1:" "shadow_map.glsl is given from lab 04 on"

edit phong 01 shade.frag 's|#include "lights.glsl"|#include "lighting.glsl"|'
refused phong 01 "lighting.glsl:1:" "lighting.glsl is given from lab 02 on"
edit phong-name 01 shade.frag 's|return u_ambient_light \* u_color;|return phong_ambient();|'
refused phong-name 01 "shade.frag:" "no function with name 'phong_ambient'"
edit phong-program 01 lab.c 's|"shade.frag"|"unshadowed.frag"|'
refused phong-program 01 "unshadowed.frag is given from lab 02 on"

edit include-target 02 lab.c "$(before '#include "target.h"')"
refused include-target 02 'error: #error "target.h is given from lab 03 on'
edit declare-target 02 lab.c "$(before 'GLuint target_create_texture(int, int, GLenum);'); $(in_create 'target_create_texture(64, 64, GL_RGBA8);')"
refused declare-target 02 "lab.c uses target_create_texture, which is given from lab 03 on"

# What all labs are given can be looked up at run time, what later ones are given cannot.
find='void *here = dlsym(RTLD_DEFAULT, "frame_bind"), *later = dlsym(RTLD_DEFAULT, "shadow_map_create"), *program = dlsym(dlopen(NULL, RTLD_NOW), "ray_hits"), *inner = dlsym(RTLD_DEFAULT, "target_create"); return check_fail("found: %d %d %d %d", here != NULL, later != NULL, program != NULL, inner != NULL);'
edit look-up 03 lab.c "$(before '#include <dlfcn.h>'); $(in_create "$find")"
refused look-up 03 "found: 1 0 0 0"

# The helpers of the labs before it are there: the target of lab 02 holds the map of lab 03.
edit earlier 03 lab.c '/^    glGenTextures(1, &state.map_texture);/,/^    glReadBuffer/c\    Target target;\n    if (!target_create(\&target, state.size, state.size, 0, GL_DEPTH_COMPONENT24))\n        return false;\n    state.map_framebuffer = target.framebuffer;\n    state.map_texture = target.depth;'
grades --lab 03 --seed 1 "$work/earlier"
expect "helpers of earlier labs" 0 "100.00 of 100 points"
finish
