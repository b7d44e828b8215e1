// The scenes of this lab: each holds only what shows its phenomenon; what varies is drawn from a seed.
#include "scene/scene_parts.h"

static void make_table(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    part_light(scene, LIGHT_SPOT, part_above(random, 45, 70, random_range(random, 9, 10)),
               vec3_make(0, 0, 0));
}

const SceneMaker LAB_TABLE[] = {
    {"@NAME@ table", make_table},
    {0},
};
