// Scenes of shadow acne and of what its cures cost.
#include "scene/scene_parts.h"

// A light at the given azimuth, low enough to graze a floor. From its near to its far plane it is always 12
// units, in which the knobs' biases are meant.
static void add_low_light(Scene *scene, LightKind kind, float azimuth, float elevation) {
    Light *light =
        part_light(scene, kind, part_orbit(vec3_make(0, 0, 0), azimuth, elevation, 10), vec3_make(0, 0, 0));
    light->far_plane = light->near_plane + 12;
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

// A one-sided card: turned about +y by `turn`, leant towards where it then faces by `lean`, to its side by
// `side`, and at last turned in its own plane by `spin` (degrees).
typedef struct Pose {
    vec3s center;
    float turn, lean, side, spin, half_size;
} Pose;

static void add_card(Scene *scene, Pose pose, Random *random) {
    Object *card =
        part_object(scene, SHAPE_PLANE, pose.center, vec3_make(1, 1, 1), pose.turn, part_color(random));
    // The second number stretches no plane, but its normal: normals come in any length.
    vec3s scale = vec3_make(pose.half_size, pose.half_size, pose.half_size * random_range(random, 0.7f, 1));
    mat4s leant = glms_rotate(card->world_from_object, glm_rad(pose.lean), vec3_make(1, 0, 0));
    mat4s tilted = glms_rotate(leant, glm_rad(pose.side), vec3_make(0, 0, 1));
    card->world_from_object = glms_scale(glms_rotate(tilted, glm_rad(pose.spin), vec3_make(0, 1, 0)), scale);
}

// The i-th of three cards in a row across the light: none shadows another, so every shadow is a false one.
static Pose row_pose(int i, float azimuth, Random *random) {
    float across = 1.9f * (float)(i - 1), along = random_range(random, -0.8f, 0.8f), a = glm_rad(azimuth);
    return (Pose){.center =
                      vec3_make(across * cosf(a) + along * sinf(a), 0, along * cosf(a) - across * sinf(a)),
                  .turn = azimuth,
                  .spin = random_range(random, -25, 25),
                  .half_size = random_range(random, 0.5f, 0.7f)};
}

static void look_down(Scene *scene, Random *random) {
    part_begin(scene, random);
    scene->camera.target = vec3_make(0, 0, 0);
    scene->camera.eye = part_orbit(scene->camera.target, random_range(random, -35, 35),
                                   random_range(random, 50, 65), random_range(random, 5.5f, 6.5f));
}

// Cards that all have the same steep slope as the light sees them, about 75 degrees.
static void make_grazing(Scene *scene, LightKind kind, Random *random) {
    float azimuth = random_range(random, 140, 220);
    look_down(scene, random);
    add_low_light(scene, kind, azimuth, random_range(random, 14, 15.5f));
    for (int i = 0; i < 3; i++) {
        Pose pose = row_pose(i, azimuth, random);
        pose.side = random_range(random, -14, 14);
        add_card(scene, pose, random);
    }
}

static void make_grazing_sun(Scene *scene, Random *random) {
    make_grazing(scene, LIGHT_DIRECTIONAL, random);
}

static void make_grazing_spot(Scene *scene, Random *random) {
    make_grazing(scene, LIGHT_SPOT, random);
}

// One card nearly faces the light, two turn away from it: each needs another bias.
static void make_slopes(Scene *scene, Random *random) {
    float azimuth = random_range(random, -40, 40), elevation = random_range(random, 30, 40);
    int facing = random_int(random, 0, 2);
    look_down(scene, random);
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, elevation);
    for (int i = 0; i < 3; i++) {
        Pose pose = row_pose(i, azimuth, random);
        float theta = i == facing ? random_range(random, 3, 6) : random_range(random, 68, 76);
        pose.lean = 90 - elevation - theta;
        add_card(scene, pose, random);
    }
}

// Three cards of three slopes, of which none needs more normal offset than another; tilted across the map's
// axes, too.
static void make_tilts(Scene *scene, LightKind kind, Random *random) {
    static const float least[] = {28, 44, 64}, most[] = {36, 52, 70};
    float azimuth = random_range(random, -40, 40), elevation = random_range(random, 38, 48);
    int first = random_int(random, 0, 2);
    look_down(scene, random);
    add_low_light(scene, kind, azimuth, elevation);
    for (int i = 0; i < 3; i++) {
        Pose pose = row_pose(i, azimuth, random);
        int slope = (first + i) % 3;
        pose.lean = 90 - elevation - random_range(random, least[slope], most[slope]);
        pose.side = (random_int(random, 0, 1) ? 1.f : -1.f) * random_range(random, 10, 20);
        add_card(scene, pose, random);
    }
}

static void make_tilts_sun(Scene *scene, Random *random) {
    make_tilts(scene, LIGHT_DIRECTIONAL, random);
}

static void make_tilts_spot(Scene *scene, Random *random) {
    make_tilts(scene, LIGHT_SPOT, random);
}

// A floor whose normal is not of length 1.
static Object *add_stretched_floor(Scene *scene, Random *random) {
    Object *floor = part_floor(scene, 4, random);
    floor->world_from_object = glms_scale(floor->world_from_object, vec3_make(1, 1.7f, 1));
    return floor;
}

// Narrow slats between the light and a floor: their shadows on it are as wide as the light between them, so
// that whatever shifts them shows everywhere. Before a spot light, which is near, they are narrower.
static void make_slats(Scene *scene, LightKind kind, Random *random) {
    float azimuth = random_range(random, 0, 360), elevation = random_range(random, 42, 52);
    float height = 2, scale = kind == LIGHT_SPOT ? 0.55f : 1, a = glm_rad(azimuth);
    vec3s color = part_color(random);
    part_begin(scene, random);
    add_stretched_floor(scene, random);
    add_low_light(scene, kind, azimuth, elevation);
    Light *light = &scene->lights[0];
    if (kind == LIGHT_SPOT) {
        light->position = part_orbit(vec3_make(0, 0, 0), azimuth, elevation, random_range(random, 5.5f, 6));
        light->fov_y = glm_rad(random_range(random, 62, 72));
        light->near_plane = random_range(random, 0.8f, 1.2f);
        light->target = part_orbit(vec3_make(0, 0, 0), azimuth + 180, 0, random_range(random, 1.6f, 2));
    } else {
        light->half_size = random_range(random, 3.3f, 4.2f);
    }
    for (int i = -1; i <= 1; i++) {
        float along = height / tanf(glm_rad(elevation)) + 0.42f * scale * (float)i;
        part_object(scene, SHAPE_BOX, vec3_make(along * sinf(a), height, along * cosf(a)),
                    vec3_make(1.6f * scale, 0.02f, 0.1f * scale), azimuth, color);
    }
    scene->camera.target = vec3_make(0, 0, 0);
    scene->camera.eye = part_orbit(scene->camera.target, azimuth + 180 + random_range(random, -35, 35),
                                   random_range(random, 40, 55), random_range(random, 4.5f, 5.5f));
}

static void make_slats_sun(Scene *scene, Random *random) {
    make_slats(scene, LIGHT_DIRECTIONAL, random);
}

static void make_slats_spot(Scene *scene, Random *random) {
    make_slats(scene, LIGHT_SPOT, random);
}

// A wall much thinner than the bias of a bad day stands on the floor; the camera looks at
// its foot on the dark side.
static void make_thin_wall(Scene *scene, Random *random) {
    float azimuth = random_range(random, 0, 360), height = random_range(random, 0.8f, 1.1f);
    vec3s foot = vec3_make(0, 0, 0);
    part_begin(scene, random);
    add_stretched_floor(scene, random);
    part_object(scene, SHAPE_BOX, vec3_make(0, height, 0),
                vec3_make(random_range(random, 1.4f, 2.2f), height, 0.02f),
                azimuth + random_range(random, -20, 20), part_color(random));
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 28, 38));
    scene->camera.eye = part_orbit(foot, azimuth + 180 + random_range(random, -40, 40),
                                   random_range(random, 40, 55), random_range(random, 4.2f, 5));
    scene->camera.target = foot;
}

static void make_thin_wall_spot(Scene *scene, Random *random) {
    make_thin_wall(scene, random);
    scene->lights[0].kind = LIGHT_SPOT;
}

// Cards over a floor: one lies flat and faces the light, one stands with its back to it.
static void make_cards(Scene *scene, Random *random) {
    float azimuth = random_range(random, 150, 210);
    int standing = random_int(random, 0, 1);
    part_begin(scene, random);
    approach(scene, 0.8f);
    part_floor(scene, 4, random);
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 45, 58));
    for (int i = 0; i < 2; i++) {
        bool stands = i == standing;
        Pose pose = {.center = vec3_make(1.6f * (float)i - 0.8f + random_range(random, -0.3f, 0.3f),
                                         random_range(random, 0.7f, 1.1f), random_range(random, -0.6f, 0.6f)),
                     .turn = azimuth,
                     .lean = stands ? random_range(random, -95, -75) : random_range(random, 5, 25),
                     .half_size = random_range(random, 0.5f, 0.7f)};
        add_card(scene, pose, random);
    }
}

// Closed boxes, sunk a little into a floor, under a low sun; none of their faces is lit at a grazing angle.
static void make_boxes(Scene *scene, Random *random) {
    float azimuth = draw_azimuth(random);
    part_begin(scene, random);
    approach(scene, 0.75f);
    part_floor(scene, 4, random);
    add_low_light(scene, LIGHT_DIRECTIONAL, azimuth, random_range(random, 28, 38));
    for (int i = 0; i < 3; i++) {
        float height = random_range(random, 0.3f, 0.7f);
        part_object(scene, SHAPE_BOX,
                    vec3_make(1.7f * (float)(i - 1) + random_range(random, -0.2f, 0.2f), height - 0.05f,
                              random_range(random, -1, 1)),
                    vec3_make(random_range(random, 0.3f, 0.5f), height, random_range(random, 0.3f, 0.5f)),
                    azimuth + 45 + random_range(random, -12, 12), part_color(random));
    }
}

const SceneMaker LAB_TABLE[] = {
    {"grazing sun", make_grazing_sun},
    {"grazing spot", make_grazing_spot},
    {"slopes", make_slopes},
    {"tilts sun", make_tilts_sun},
    {"tilts spot", make_tilts_spot},
    {"slats sun", make_slats_sun},
    {"slats spot", make_slats_spot},
    {"thin wall", make_thin_wall},
    {"thin wall spot", make_thin_wall_spot},
    {"cards", make_cards},
    {"boxes", make_boxes},
    {0},
};
