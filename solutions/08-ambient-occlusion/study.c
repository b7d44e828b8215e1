// Ambient occlusion in the study, and the scene that it is seen in.
#include "study_faster.h"
#include "scene/atlas.h"
#include "scene/count.h"
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <stdlib.h>
#include <string.h>

#define FASTER "faster sky"

// A floor, a wall and a box that touch, under a sky that is equally bright everywhere.
static void make_occlusion(Scene *scene) {
    *scene = closed_wall(1.5f, 10, 1);
    study_look(scene, vec3_make(1.7f, 1.9f, 3.1f), vec3_make(-0.05f, 0.35f, 0));
    scene->objects[0].world_from_object.raw[3][1] = 1.5f;
    scene->objects[0].world_from_object.raw[3][2] = -1.2f;
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0.3f), vec3_make(1.5f, 1, 1.5f), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-0.2f, 0.35f, -0.1f), vec3_make(0.4f, 0.35f, 0.4f), 25);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(3, 8, 4), vec3_make(0, 0, 0), 0, 3, 4, 16);
}

// Rays as long as this, world units, see what is near; the names are those of their scenes.
static const struct Near {
    const char *scene;
    float length;
} near[] = {{"occlusion 0.25", 0.25f}, {"occlusion 0.5", 0.5f}, {"occlusion 1", 1}};

static const StudyScene scenes[] = {
    {"occlusion",
     "An even sky: ambient occlusion",
     "a corner and a contact",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 4096, .seed = 1},
     false,
     STUDY_SOFT,
     .moves = false},
    {"occlusion 0.25",
     "Ambient occlusion by what is nearer than 0.25",
     "a corner and a contact; rays in the truth, the bake and the screen are equally long",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 1024, .limit = 0.25f, .seed = 1},
     false,
     STUDY_SOFT,
     .moves = false},
    {"occlusion 0.5",
     "Ambient occlusion by what is nearer than 0.5",
     "a corner and a contact; rays in the truth, the bake and the screen are equally long",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 1024, .limit = 0.5f, .seed = 1},
     false,
     STUDY_SOFT,
     .moves = false},
    {"occlusion 1",
     "Ambient occlusion by what is nearer than 1",
     "a corner and a contact; rays in the truth, the bake and the screen are equally long",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 4096, .limit = 1, .seed = 1},
     false,
     STUDY_SOFT,
     .moves = false},
    {FASTER,
     "Ambient occlusion: the same bake and the same screen, faster",
     "what bounding spheres, a compiler that optimises, half the size and two factors save",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 1024, .limit = 0.5f, .seed = 1},
     false,
     STUDY_SOFT,
     .moves = false},
    {0},
};

// Texels of all charts, and a ray from each of them as often as the knob says; padding is copied.
static void add_bake(Cost *cost, const Method *method, const Scene *scene) {
    Atlas *atlas = calloc(1, sizeof *atlas);
    if (atlas && atlas_layout(atlas, scene, method_knob(method, "texel density", 4), 1))
        for (int c = 0; c < atlas->chart_count; c++)
            cost->atlas += (double)atlas->charts[c].width * atlas->charts[c].height;
    cost->rays = cost->atlas * (double)method_knob(method, "rays", 64);
    if (atlas)
        atlas_destroy(atlas);
    free(atlas);
}

// The bake compiled for speed, as no lab is.
#define OPTIMISED                                                                                            \
    { "lab.c", "#include \"atlas.h\"\n", "#pragma GCC optimize(\"O2\")\n#include \"atlas.h\"\n" }
static const Change optimised = {.name = "bake at -O2", .edits = {OPTIMISED}, .edit_count = 1};

// A ray asks an object only when it meets the sphere around it. H. Weghorst, G. Hooper, D. Greenberg:
// Improved Computational Methods for Ray Tracing, 1984. All shapes lie in the cube from -1 to 1, in
// orthogonal axes.
const Change occlusion_spheres = {
    .name = "bake at -O2, bounding spheres first",
    .edits =
        {OPTIMISED,
         {"lab.c", "// Share of the rays from this place",
          "static bool meets_sphere(const Object *object, vec3s origin, vec3s direction, float length) {\n"
          "    const mat4s *world = &object->world_from_object;\n"
          "    float radius_squared = 0;\n"
          "    for (int i = 0; i < 3; i++)\n"
          "        radius_squared += glms_vec3_norm2(glms_vec3(world->col[i]));\n"
          "    vec3s to_center = glms_vec3_sub(glms_vec3(world->col[3]), origin);\n"
          "    float along = glms_vec3_dot(to_center, direction), squared = glms_vec3_norm2(to_center);\n"
          "    if (squared <= radius_squared)\n"
          "        return true; // from inside\n"
          "    float half_squared = radius_squared - (squared - along * along);\n"
          "    return along > 0 && half_squared >= 0 &&\n"
          "           (along <= length || half_squared >= (along - length) * (along - length));\n"
          "}\n\n"
          "static bool hits_near(const Scene *scene, vec3s origin, vec3s direction, float length) {\n"
          "    static Scene one = {.object_count = 1};\n"
          "    for (int i = 0; i < scene->object_count; i++) {\n"
          "        if (!meets_sphere(&scene->objects[i], origin, direction, length))\n"
          "            continue;\n"
          "        one.objects[0] = scene->objects[i];\n"
          "        if (ray_hits(&one, origin, direction, length))\n"
          "            return true;\n"
          "    }\n"
          "    return false;\n"
          "}\n\n"
          "// Share of the rays from this place"},
         {"lab.c", "hits += ray_hits(", "hits += hits_near("}},
    .edit_count = 3};

// `length` of the rays, world units; 0: they have no end.
static Method *add_baked(MethodList *list, const char *family, int density, int rays, float length) {
    Method *method = method_add(list, LAB_ID, family, "%d texels a unit, %d rays", density, rays);
    setting_knob(&method->setting, "texel density", (float)density);
    setting_knob(&method->setting, "rays", (float)rays);
    if (length > 0)
        setting_knob(&method->setting, "ray length", length);
    method->by_processor = true;
    method->texel_bytes = 4; // GL_R32F
    method->add_cost = add_bake;
    return method;
}

// The occlusion of every second pixel of every second row, which its three neighbours take over.
const Change occlusion_half_size = {
    .name = "screen space at half size",
    .edits = {{"lab.c", "target_create(&state.screen, frame->width, frame->height, GL_RGBA8, 0)",
               "target_create(&state.screen, (frame->width + 1) / 2, (frame->height + 1) / 2, GL_RGBA8, 0)"},
              {"occlusion.frag", "ivec2(gl_FragCoord.xy), 0)", "ivec2(gl_FragCoord.xy) / 2, 0)"}},
    .edit_count = 2};

// A symmetrical perspective needs two factors, no matrix.
const Change occlusion_two_factors = {
    .name = "screen space, projected by two factors",
    .edits = {{"ssao.frag",
               "    vec4 point_clip = u_clip_from_view * vec4(point_view, 1.0);\n"
               "    float seen = seen_distance(point_clip.xy / point_clip.w * 0.5 + 0.5);\n",
               "    vec2 factors = vec2(u_clip_from_view[0][0], u_clip_from_view[1][1]);\n"
               "    float seen = seen_distance(factors * point_view.xy / -point_view.z * 0.5 + 0.5);\n"}},
    .edit_count = 1};

static Method *add_screen(MethodList *list, const char *family, float length) {
    Method *method = method_add(list, LAB_ID, family, "radius %g", (double)length);
    setting_knob(&method->setting, "method", 1);
    setting_knob(&method->setting, "ray length", length);
    method->picture_bytes = 4; // GL_RGBA8
    return method;
}

// What stands in "occlusion 0.5", and the same in less time.
static void add_faster(MethodList *list) {
    const float length = 0.5f;
    for (int density = 4; density <= 16; density *= 2) {
        add_baked(list, "baked", density, 64, length);
        add_baked(list, "baked at -O2", density, 64, length)->change = &optimised;
        add_baked(list, "baked at -O2, spheres first", density, 64, length)->change = &occlusion_spheres;
    }
    add_screen(list, "screen space", length);
    add_screen(list, "screen space, two factors", length)->change = &occlusion_two_factors;
    Method *half = add_screen(list, "screen space, half size", length);
    half->change = &occlusion_half_size;
    half->picture_bytes = 1; // a quarter of the pixels
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "occlusion") == 0)
        for (int density = 2; density <= 16; density *= 2)
            for (int rays = 4; rays <= 256 && density * density * rays <= 16384; rays *= 4)
                add_baked(list, "baked", density, rays, 0);
    for (unsigned i = 0; i < COUNT(near); i++)
        if (strcmp(scene, near[i].scene) == 0) {
            add_screen(list, "screen space", near[i].length);
            for (int density = 2; density <= 16; density *= 2)
                add_baked(list, "baked", density, 64, near[i].length);
        }
    if (strcmp(scene, FASTER) == 0)
        add_faster(list);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
