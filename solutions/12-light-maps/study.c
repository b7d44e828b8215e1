// Light maps in the study: a wide lamp over what stands still, with more and more luxels and rays, and hard
// light beside shadow maps.
#include "scene/atlas.h"
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <stdlib.h>
#include <string.h>

// Boxes between a wide lamp and a floor.
static void make_still(Scene *scene) {
    *scene = (Scene){0};
    study_look(scene, vec3_make(0.4f, 3, 4.6f), vec3_make(0, 0.2f, 0));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(2, 1, 2), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-0.7f, 0.4f, 0.1f), vec3_make(0.3f, 0.4f, 0.3f), 30);
    closed_add(scene, SHAPE_BOX, vec3_make(0.7f, 0.9f, 0.2f), vec3_make(0.4f, 0.1f, 0.4f), 15);
    closed_light(scene, LIGHT_SPOT, vec3_make(0.6f, 4.5f, -1.5f), vec3_make(0, 0.2f, 0), glm_rad(60), 0, 1,
                 14);
    scene->lights[0].extent = 0.4f;
}

static const StudyScene scenes[] = {
    {"baked light",
     "A wide lamp over what stands still: light maps",
     "soft shadows of boxes that do not move",
     make_still,
     {.kind = TRUTH_LIGHT, .samples = 1024, .seed = 1},
     true,
     STUDY_SOFT,
     .moves = false},
    {0},
};

// Luxels of all charts, and a ray from each of them as often as the knob says.
static void add_bake(Cost *cost, const Method *method, const Scene *scene) {
    Atlas *atlas = calloc(1, sizeof *atlas);
    if (atlas && atlas_layout(atlas, scene, method_knob(method, "luxel density", 4), 1))
        for (int c = 0; c < atlas->chart_count; c++)
            cost->atlas += (double)atlas->charts[c].width * atlas->charts[c].height;
    cost->rays = cost->atlas * (double)method_knob(method, "rays", 64);
    if (atlas)
        atlas_destroy(atlas);
    free(atlas);
}

// Without padding a lookup at a chart's border blends with what is not baked. (The knob "memory" only makes
// luxels fewer, which is charted already.)
static void add_baked(MethodList *list, int density, int rays, int padding) {
    Method *method = method_add(list, LAB_ID, padding ? "light map, rays" : "light map, rays, no padding",
                                "%d luxels a unit, %d rays", density, rays);
    setting_knob(&method->setting, "luxel density", (float)density);
    setting_knob(&method->setting, "padding", (float)padding);
    setting_knob(&method->setting, "rays", (float)rays);
    method->add_cost = add_bake;
    method->texel_bytes = 16; // two textures of GL_RGBA16F
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "baked light") != 0)
        return;
    for (int density = 2; density <= 16; density *= 2)
        for (int rays = 4; rays <= 256 && density * density * rays <= 16384; rays *= 4)
            add_baked(list, density, rays, 1);
    add_baked(list, 16, 64, 0);
    Method *hard = method_add_map(list, LAB_ID, "light map, shadow map", 512, "%s", "16 luxels a unit");
    setting_knob(&hard->setting, "luxel density", 16);
    setting_knob(&hard->setting, "shadows", 2);
    for (int i = 0; i < STUDY_SIZES; i += 2)
        method_add_map(list, "03", "basic map", study_sizes[i], "%s", "");
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
