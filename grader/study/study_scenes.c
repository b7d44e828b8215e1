#include "study/study_scenes.h"

#include "truth/closed_scenes.h"
#include "scene/scene_parts.h"

// An object turned in the plane of the picture of a camera at +z, by `turn` degrees about +z.
static void add_turned(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn) {
    closed_add(scene, shape, center, half_size, 0);
    mat4s turned = glms_rotate(glms_translate_make(center), glm_rad(turn), vec3_make(0, 0, 1));
    scene->objects[scene->object_count - 1].world_from_object = glms_scale(turned, half_size);
}

static void look(Scene *scene, vec3s eye, vec3s target) {
    scene->camera =
        (Camera){.eye = eye, .target = target, .fov_y = glm_rad(40), .near_plane = 0.5f, .far_plane = 60};
}

// A floor with bumps of several slopes and a thin wall, under a low sun: what needs a bias, and what a bias
// detaches.
static void make_bias(Scene *scene) {
    *scene = (Scene){0};
    look(scene, vec3_make(0.9f, 3.9f, 4.1f), vec3_make(-0.25f, 0.1f, 0));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(3.4f, 1, 3.4f), 0);
    for (int i = 0; i < 3; i++)
        add_turned(scene, SHAPE_BOX, vec3_make(-1.9f, -0.1f, 1.4f * (float)i - 1.6f),
                   vec3_make(0.4f, 0.4f, 0.5f), 15 + 15 * (float)i);
    closed_add(scene, SHAPE_BOX, vec3_make(0.4f, 0.45f, 0), vec3_make(0.02f, 0.45f, 1.3f), 12);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(-8, 5.6f, 2), vec3_make(0, 0, 0), 0, 3.6f, 4, 16);
}

// Plates before a wall, both square to the light: no bias is needed, and the edge shows the map's texels and
// its filter alone, in many directions.
static void make_edges(Scene *scene) {
    *scene = closed_wall(3.2f, 10, glm_rad(36));
    look(scene, vec3_make(2.7f, 0.7f, 4.3f), vec3_make(0.1f, 0, 0));
    for (int i = 0; i < 4; i++)
        add_turned(scene, SHAPE_BOX, vec3_make(i % 2 ? 0.9f : -0.9f, i / 2 ? 0.7f : -0.7f, 0.8f),
                   vec3_make(0.7f, 0.3f, 0.01f), 8 + 23 * (float)i);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 10), vec3_make(0, 0, 0), 0, 3.2f, 4, 16);
}

// The lamp of the scene "penumbra": a disc parallel to the wall. Seen from the wall through the plates'
// plane, at height h of H, it has the radius r h / H there; the map, of half width (H - h) tan(fov / 2)
// there, sees that as 2 / SCENES_KERNEL of its half width.
enum { LAMP_HEIGHT = 10, PLATE_HEIGHT = 2 };
static const float lamp_fov = 0.62f;
#define LAMP_TANGENT 0.3203275F // tan(lamp_fov / 2)
#define LAMP_RADIUS                                                                                          \
    (2 * (LAMP_HEIGHT - PLATE_HEIGHT) * LAMP_TANGENT / SCENES_KERNEL * LAMP_HEIGHT / PLATE_HEIGHT)

// Plates at one height before a wall, so that one kernel fits; two bars and pebbles that are narrower than
// it.
static void make_penumbra(Scene *scene) {
    const float h = PLATE_HEIGHT;
    *scene = closed_wall(3.2f, 10, glm_rad(36));
    look(scene, vec3_make(2.9f, 0.4f, 2.5f), vec3_make(-0.15f, 0, 0));
    add_turned(scene, SHAPE_BOX, vec3_make(-0.7f, 0.5f, h), vec3_make(0.45f, 0.25f, 0.01f), 20);
    add_turned(scene, SHAPE_BOX, vec3_make(-0.6f, -0.6f, h), vec3_make(0.5f, 0.035f, 0.01f), -10);
    add_turned(scene, SHAPE_BOX, vec3_make(0.5f, 0.1f, h), vec3_make(0.035f, 0.6f, 0.01f), 30);
    for (int i = 0; i < 4; i++)
        add_turned(scene, SHAPE_BOX, vec3_make(-0.95f + 0.3f * (float)i, -0.1f, h),
                   vec3_make(0.04f, 0.04f, 0.01f), 20 * (float)i);
    closed_light(scene, LIGHT_SPOT, vec3_make(0, 0, LAMP_HEIGHT), vec3_make(0, 0, 0), lamp_fov, 0, 4, 16);
}

// Closed casters under a lamp behind the camera, and a plate that keeps the lamp from the eye: it stands in a
// volume.
static void make_volumes(Scene *scene) {
    const vec3s eye = vec3_make(0.2f, 2.7f, 4.7f), lamp = vec3_make(4.2f, 5, 4.6f);
    *scene = (Scene){0};
    look(scene, eye, vec3_make(-0.35f, 0.15f, 0));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(4, 1, 4), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-1, 0.6f, 0.4f), vec3_make(0.5f, 0.6f, 0.5f), 30);
    closed_add(scene, SHAPE_SPHERE, vec3_make(0.9f, 0.9f, -0.3f), vec3_make(0.55f, 0.55f, 0.55f), 0);
    closed_add(scene, SHAPE_BOX, glms_vec3_lerp(eye, lamp, 0.5f), vec3_make(0.3f, 0.05f, 0.3f), 20);
    closed_light(scene, LIGHT_SPOT, lamp, vec3_make(-0.2f, 0.6f, 0), glm_rad(60), 0, 1, 18);
}

// A floor, a wall and a box that touch, under a sky that is equally bright everywhere.
static void make_occlusion(Scene *scene) {
    *scene = closed_wall(1.5f, 10, 1);
    look(scene, vec3_make(1.7f, 1.9f, 3.1f), vec3_make(-0.05f, 0.35f, 0));
    scene->objects[0].world_from_object.raw[3][1] = 1.5f;
    scene->objects[0].world_from_object.raw[3][2] = -1.2f;
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0.3f), vec3_make(1.5f, 1, 1.5f), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-0.2f, 0.35f, -0.1f), vec3_make(0.4f, 0.35f, 0.4f), 25);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(3, 8, 4), vec3_make(0, 0, 0), 0, 3, 4, 16);
}

#define HARD_TOLERANCE 1e-4        // one pixel in ten thousand: at the creases of a mesh a slope says little
#define SOFT_TOLERANCE (2 / 255.0) // what counts as equal in grading

const StudyScene study_scenes[] = {
    {"bias",
     "Hard light on slopes: bias",
     "slopes that shadow themselves, and a thin wall that a bias detaches",
     make_bias,
     {.kind = TRUTH_LIGHT},
     methods_of_bias,
     true,
     HARD_TOLERANCE},
    {"edges",
     "Hard light on plates: texels and filters",
     "long edges in many directions: the texels show, and what a filter makes of them",
     make_edges,
     {.kind = TRUTH_LIGHT},
     methods_of_edges,
     true,
     HARD_TOLERANCE},
    {"penumbra",
     "A disc of light: wide penumbrae",
     "one width of penumbra, and casters narrower than it",
     make_penumbra,
     {.kind = TRUTH_DISC,
      .area = {{{0, 0, LAMP_HEIGHT}}, {{LAMP_RADIUS, 0, 0}}, {{0, LAMP_RADIUS, 0}}},
      .samples = 1024,
      .seed = 1},
     methods_of_penumbra,
     true,
     SOFT_TOLERANCE},
    {"volumes",
     "The eye in a shadow: volumes and maps",
     "closed casters; the eye stands in a volume",
     make_volumes,
     {.kind = TRUTH_LIGHT},
     methods_of_volumes,
     true,
     HARD_TOLERANCE},
    {"occlusion",
     "An even sky: ambient occlusion",
     "a corner and a contact",
     make_occlusion,
     {.kind = TRUTH_OCCLUSION, .samples = 1024, .seed = 1},
     methods_of_occlusion,
     false,
     SOFT_TOLERANCE},
    {0},
};
