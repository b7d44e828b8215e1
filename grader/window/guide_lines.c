#include "window/guide_lines.h"

#include "shadow_map.h"

static const float CROSS = 0.12F; // world units

static void add(GuideLines *lines, vec3s from, vec3s to) {
    if (lines->count + 2 > GUIDE_MOST_ENDS)
        return;
    lines->ends[lines->count++] = from;
    lines->ends[lines->count++] = to;
}

// The corner of a cube of side 2 whose number has these bits: x, y, z.
static vec3s cube_corner(int i) {
    return vec3_make(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
}

static void add_map(GuideLines *lines, const Light *light) {
    const mat4s world_from_clip = glms_mat4_inv(shadow_map_clip_from_world(light));
    vec3s corners[8];
    for (int i = 0; i < 8; i++) {
        const vec4s corner = glms_mat4_mulv(world_from_clip, glms_vec4(cube_corner(i), 1));
        corners[i] = glms_vec3_divs(glms_vec3(corner), corner.w);
    }
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit))
                add(lines, corners[i], corners[i | bit]);
}

static void add_cube(GuideLines *lines, const Light *light) {
    for (int i = 0; i < 8; i++)
        add(lines, light->position,
            glms_vec3_add(light->position, glms_vec3_scale(cube_corner(i), light->far_plane)));
}

static void add_lamp(GuideLines *lines, const Light *light) {
    vec3s right, up, corners[4];
    light_axes(light, &right, &up);
    for (int i = 0; i < 4; i++) {
        const float a = i == 1 || i == 2 ? light->extent : -light->extent,
                    b = i < 2 ? -light->extent : light->extent;
        corners[i] =
            glms_vec3_add(light->position, glms_vec3_add(glms_vec3_scale(right, a), glms_vec3_scale(up, b)));
    }
    for (int i = 0; i < 4; i++)
        add(lines, corners[i], corners[(i + 1) % 4]);
}

void guide_lines_add(GuideLines *lines, const Light *light) {
    for (int axis = 0; axis < 3; axis++) {
        vec3s arm = {{0, 0, 0}};
        arm.raw[axis] = CROSS;
        add(lines, glms_vec3_sub(light->position, arm), glms_vec3_add(light->position, arm));
    }
    if (light->kind == LIGHT_POINT)
        add_cube(lines, light);
    else
        add_map(lines, light);
    if (light->extent > 0)
        add_lamp(lines, light);
}
