// Scenes of shadow acne and of what its cures cost.
#include "scene_parts.h"

// A light at the given azimuth, low enough to graze a floor.
static void add_low_light(Scene *scene, LightKind kind, float azimuth, float elevation) {
    part_light(scene, kind, part_orbit(vec3_make(0, 0, 0), azimuth, elevation, 10), vec3_make(0, 0, 0));
}

// Behind the scene as a camera near +z sees it, left or right.
static float draw_azimuth(Random *random) {
    float side = random_int(random, 0, 1) ? 1 : -1;
    return side * random_range(random, 110, 160);
}

// Brings the camera nearer to what it looks at.
static void approach(Scene *scene, float share) {
    scene->camera.eye = glms_vec3_lerp(scene->camera.target, scene->camera.eye, share);
}

// A one-sided card about `center`. The scale in y changes nothing but the length of the normal, which every shader has
// to normalise.
static void add_card(Scene *scene, vec3s center, float half_size, float turn, float tilt, Random *random) {
    Object *card = part_object(scene, SHAPE_PLANE, center, vec3_make(1, 1, 1), turn, part_color(random));
    vec3s scale = vec3_make(half_size, random_range(random, 0.35f, 0.45f), half_size * random_range(random, 0.7f, 1));
    card->world_from_object =
        glms_scale(glms_rotate(card->world_from_object, glm_rad(tilt), vec3_make(1, 0, 0)), scale);
}

// Cards beside each other under grazing light, each with a slope of its own: none shadows another, so every shadow is
// a false one.
static void make_tiles(Scene *scene, LightKind kind, Random *random) {
    part_begin(scene, random);
    scene->camera.target.y = 0;
    approach(scene, 0.7f);
    add_low_light(scene, kind, draw_azimuth(random), random_range(random, 25, 32));
    for (int i = 0; i < 3; i++) {
        vec3s center = vec3_make(1.9f * (float)(i - 1) + random_range(random, -0.2f, 0.2f), 0,
                                 random_range(random, -1.2f, 1.2f));
        add_card(scene, center, random_range(random, 0.6f, 1.1f), random_range(random, 0, 360),
                 random_range(random, 2, 14), random);
    }
}

static void make_tiles_sun(Scene *scene, Random *random) {
    make_tiles(scene, LIGHT_DIRECTIONAL, random);
}

static void make_tiles_spot(Scene *scene, Random *random) {
    make_tiles(scene, LIGHT_SPOT, random);
}

// A wall much thinner than the bias of a bad day stands on the floor; the camera looks at its foot on the dark side.
static void make_thin_wall(Scene *scene, Random *random) {
    float azimuth = random_range(random, 0, 360), height = random_range(random, 0.8f, 1.1f);
    vec3s foot = vec3_make(0, 0, 0);
    part_begin(scene, random);
    part_floor(scene, 4, random);
    part_object(scene, SHAPE_BOX, vec3_make(0, height, 0), vec3_make(random_range(random, 1.2f, 2), height, 0.02f),
                azimuth + random_range(random, -20, 20), part_color(random));
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 28, 38));
    scene->camera.eye = part_orbit(foot, azimuth + 180 + random_range(random, -40, 40), random_range(random, 40, 55),
                                   random_range(random, 4.5f, 5.5f));
    scene->camera.target = foot;
}

// Cards over a floor, turned to the light or away from it.
static void make_cards(Scene *scene, Random *random) {
    float azimuth = draw_azimuth(random);
    int turned_away = random_int(random, 0, 1);
    part_begin(scene, random);
    approach(scene, 0.8f);
    part_floor(scene, 4, random);
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 45, 60));
    for (int i = 0; i < 4; i++) {
        vec3s center = vec3_make(1.6f * (float)(i % 2) - 0.8f + random_range(random, -0.3f, 0.3f),
                                 random_range(random, 0.7f, 1.1f),
                                 1.8f * (float)(i / 2) - 0.9f + random_range(random, -0.3f, 0.3f));
        bool away = (i + i / 2 + turned_away) % 2;
        add_card(scene, center, random_range(random, 0.5f, 0.7f), azimuth,
                 random_range(random, 20, 50) + (away ? 180.0f : 0), random);
    }
}

// Closed boxes on a floor under a low sun; none of their faces is lit at a grazing angle.
static void make_boxes(Scene *scene, Random *random) {
    float azimuth = draw_azimuth(random);
    part_begin(scene, random);
    approach(scene, 0.75f);
    part_floor(scene, 4, random);
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 28, 38));
    for (int i = 0; i < 3; i++) {
        float height = random_range(random, 0.3f, 0.7f);
        part_object(scene, SHAPE_BOX,
                    vec3_make(1.7f * (float)(i - 1) + random_range(random, -0.2f, 0.2f), height,
                              random_range(random, -1, 1)),
                    vec3_make(random_range(random, 0.3f, 0.5f), height, random_range(random, 0.3f, 0.5f)),
                    azimuth + 45 + random_range(random, -12, 12), part_color(random));
    }
}

const SceneMaker scenes_bias[] = {
    {"tiles sun", make_tiles_sun}, {"tiles spot", make_tiles_spot}, {"thin wall", make_thin_wall},
    {"cards", make_cards},         {"boxes", make_boxes},           {0},
};
