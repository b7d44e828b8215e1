// The same filters in less time, on the plates of "edges": a map that is kept while nothing moves, one of
// what casts alone, and kernels from fewer lookups. Each is an edit of this lab, which no student writes.
#include "study_filters.h"

#include <string.h>

static const StudyScene scenes[] = {
    {FASTER,
     "Hard light on plates: the same filters, faster",
     "what a map that is kept, a map of the casters alone, and fewer lookups save",
     filters_make_edges,
     {.kind = TRUTH_LIGHT},
     true,
     STUDY_HARD,
     .moves = false},
    {0},
};

// The map is drawn again only where the light, an object or the offset has changed.
const Change filter_kept = {
    .name = "the map is kept while nothing moves",
    .edits = {FILTER_FIXED("2"),
              {"lab.c", "#include \"lab.h\"\n", "#include \"lab.h\"\n\n#include <string.h>\n"},
              {"lab.c", "    ShadowMap map;\n",
               "    ShadowMap map;\n    Scene drawn; // in the map, without its cameras\n"
               "    float reach;\n    bool kept;\n"},
              {"lab.c", "    shadow_map_destroy(&state.map);\n",
               "    shadow_map_destroy(&state.map);\n    state.kept = false;\n"},
              {"lab.c", "    shadow_map_begin(&state.map);\n",
               "    static Scene now;\n"
               "    now = *frame->scene;\n"
               "    now.camera = now.second_camera = (Camera){.fov_y = 0};\n"
               "    if (state.kept && state.reach == reach && memcmp(&now, &state.drawn, sizeof now) == 0)\n"
               "        return;\n"
               "    state.drawn = now;\n    state.reach = reach;\n    state.kept = true;\n"
               "    shadow_map_begin(&state.map);\n"}},
    .edit_count = 5};

// What only receives is not in the map: a plane casts no shadow on what lies before it.
const Change filter_casters = {
    .name = "the map holds casters only",
    .edits = {FILTER_FIXED("2"),
              {"lab.c",
               "    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light), "
               "light->position);\n",
               "    static Scene casters;\n"
               "    Frame only = *frame;\n"
               "    casters = *frame->scene;\n"
               "    casters.object_count = 0;\n"
               "    for (int i = 0; i < frame->scene->object_count; i++)\n"
               "        if (frame->scene->objects[i].shape != SHAPE_PLANE)\n"
               "            casters.objects[casters.object_count++] = frame->scene->objects[i];\n"
               "    only.scene = &casters;\n"
               "    draw_scene(&only, &only.programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light), "
               "light->position);\n"}},
    .edit_count = 2};

// Along one axis the box of 2 r + 1 lookups, each a blend of two texels, weighs 2 r + 2 texels by
// 1 - f, 1, ..., 1, f. They are taken in r + 1 pairs.
#define BOX_LOOP                                                                                             \
    "    for (int y = -u_radius; y <= u_radius; y++)\n"                                                      \
    "        for (int x = -u_radius; x <= u_radius; x++)\n"                                                  \
    "            lit += texture(u_shadow_map, vec3(position_map.xy + vec2(x, y) * texel, "                   \
    "position_map.z));\n"
#define BOX_PAIRS(lookup)                                                                                    \
    "    vec2 place = position_map.xy / texel - 0.5, corner = floor(place), f = place - corner;\n"           \
    "    for (int y = 0; y <= u_radius; y++)\n"                                                              \
    "        for (int x = 0; x <= u_radius; x++) {\n"                                                        \
    "            ivec2 pair = ivec2(x, y);\n"                                                                \
    "            vec2 low = mix(vec2(1.0), 1.0 - f, equal(pair, ivec2(0)));\n"                               \
    "            vec2 high = mix(vec2(1.0), f, equal(pair, ivec2(u_radius)));\n"                             \
    "            vec2 first = corner + 2.0 * vec2(pair) - float(u_radius); // texel of the pair\n" lookup    \
    "        }\n"

// A linear lookup between two texels blends them as they weigh.
const Change filter_between = {
    .name = "box by lookups between texels",
    .edits = {FILTER_FIXED("4"),
              {"shadow.frag", BOX_LOOP,
               BOX_PAIRS("            vec2 at = (first + 0.5 + high / (low + high)) * texel;\n"
                         "            lit += (low.x + high.x) * (low.y + high.y) *\n"
                         "                   texture(u_shadow_map, vec3(at, position_map.z));\n")}},
    .edit_count = 2};

const Change filter_gathers = {
    .name = "box by gathers",
    .edits = {FILTER_FIXED("4"),
              {"shadow.frag", BOX_LOOP,
               BOX_PAIRS("            vec4 answers = textureGather(u_shadow_map, (first + 1.0) * texel, "
                         "position_map.z);\n"
                         "            lit += dot(answers, vec4(low.x, high.x, high.x, low.x) *\n"
                         "                                    vec4(high.y, high.y, low.y, low.y));\n")}},
    .edit_count = 2};

// A tent two texels wide in the place of the box: along one axis (1 - f, 2 - f, 1 + f, f) / 4, with the same
// four gathers. I. Castano: Shadow Mapping Summary, 2013.
const Change filter_tent = {
    .name = "tent by gathers",
    .edits = {FILTER_FIXED("5"),
              {"shadow.frag", "vec2 low = mix(1.0 - f, vec2(1.0), far), high = mix(vec2(1.0), f, far);",
               "vec2 low = mix(1.0 - f, 1.0 + f, far), high = mix(2.0 - f, f, far);"},
              {"shadow.frag", "    }\n    return lit / 9.0;", "    }\n    return lit / 16.0;"}},
    .edit_count = 3};

static void add(MethodList *list, Filter filter, const Change *change) {
    for (int i = 0; i < STUDY_SIZES; i++) {
        Method *method = filters_add(list, filter, study_sizes[i]);
        method->change = change ? change : method->change;
    }
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, FASTER) != 0)
        return;
    add(list, filter_linear, NULL);
    add(list, (Filter){"linear, the map is kept", 2, 0, 0}, &filter_kept);
    add(list, (Filter){"linear, a map of casters", 2, 0, 0}, &filter_casters);
    add(list, filter_gather, NULL);
    add(list, (Filter){"3 x 3 tent by gathers", 5, 0, 1}, &filter_tent);
    add(list, filter_box_5, NULL);
    add(list, (Filter){"box 5 x 5, 9 gathers", 4, 2, 2}, &filter_gathers);
    add(list, (Filter){"box 5 x 5, 9 between texels", 4, 2, 2}, &filter_between);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
