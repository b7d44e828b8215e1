// Scenes of shading without shadows.
#include "scene/scene_parts.h"

static Object *shiny(Object *object, Random *random) {
    // Wide highlights: many pixels tell one model from another.
    object->specular = random_range(random, 0.6f, 0.8f);
    object->shininess = random_range(random, 4, 8);
    return object;
}

static void place_shapes(Scene *scene, float side, Random *random) {
    float r = random_range(random, 0.7f, 0.9f), h = random_range(random, 0.8f, 1.3f);
    vec3s sphere = vec3_make(side * random_range(random, 0.9f, 1.2f), r, random_range(random, 0.4f, 0.9f));
    shiny(part_object(scene, SHAPE_SPHERE, sphere, vec3_make(r, r, r), 0, part_color(random)), random);
    vec3s box = vec3_make(side * random_range(random, 1.2f, 1.6f), h, random_range(random, -1.4f, -1));
    vec3s half_size = vec3_make(random_range(random, 0.5f, 0.7f), h, random_range(random, 0.5f, 0.7f));
    float turn = random_range(random, 20, 70);
    shiny(part_object(scene, SHAPE_BOX, box, half_size, turn, part_color(random)), random);
    r = random_range(random, 0.25f, 0.35f);
    sphere = vec3_make(side * random_range(random, 0.6f, 0.9f), r, random_range(random, 1.8f, 2));
    shiny(part_object(scene, SHAPE_SPHERE, sphere, vec3_make(r, r, r), 0, part_color(random)), random);
}

// Two spheres and a box on each side of the middle, lit from the side: faces in the light, faces turned away
// from it, highlights that the camera sees. The lamp is near: its direction differs from point to point.
static void make_shapes(Scene *scene, Random *random) {
    part_begin(scene, random);
    float dim = random_range(random, 0.25f, 0.35f);
    scene->ambient = vec3_make(dim, dim, dim * 1.1f);
    scene->camera.eye = part_orbit(scene->camera.target, random_range(random, -25, 25),
                                   random_range(random, 20, 35), random_range(random, 6.5f, 7.5f));
    shiny(part_floor(scene, 3, random), random);
    place_shapes(scene, -1, random);
    place_shapes(scene, 1, random);
    float azimuth = (random_int(random, 0, 1) ? 1.f : -1.f) * random_range(random, 40, 80);
    part_light(scene, LIGHT_SPOT, part_orbit(vec3_make(0, 0, 0), azimuth, random_range(random, 25, 40), 5),
               vec3_make(0, 0, 0));
}

// The same with the lamp behind the shapes and low: where their faces turn from it, the mirrored ray still
// meets the eye.
static void make_backlit(Scene *scene, Random *random) {
    make_shapes(scene, random);
    float azimuth = (random_int(random, 0, 1) ? 1.f : -1.f) * random_range(random, 160, 178);
    scene->lights[0].position =
        part_orbit(vec3_make(0, 0.5f, 0), azimuth, random_range(random, 6, 12), random_range(random, 5, 6));
    for (int i = 0; i < scene->object_count; i++)
        scene->objects[i].shininess = random_range(random, 2, 3);
}

const SceneMaker LAB_TABLE[] = {
    {"shapes", make_shapes},
    {"shapes backlit", make_backlit},
    {0},
};
