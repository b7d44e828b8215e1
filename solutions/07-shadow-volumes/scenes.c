// Scenes of shadow volumes: closed casters over a floor, which is open and so casts nothing.
#include "scene/scene_parts.h"

// A place for a light above the origin, to the left or right of the camera by an angle in degrees.
static vec3s beside(const Scene *scene, Random *random, float least, float most, float elevation) {
    float camera = glm_deg(atan2f(scene->camera.eye.x, scene->camera.eye.z));
    float side = random_int(random, 0, 1) ? 1 : -1;
    return part_orbit(vec3_make(0, 0, 0), camera + side * random_range(random, least, most), elevation, 9);
}

// The floor has a wide highlight, which moves with the eye.
static void make_volume_spot(Scene *scene, Random *random) {
    part_begin(scene, random);
    Object *floor = part_floor(scene, 6, random);
    part_casters(scene, random);
    vec3s lamp = beside(scene, random, 35, 80, random_range(random, 35, 55));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    floor->specular = random_range(random, 0.6f, 0.8f);
    floor->shininess = random_range(random, 4, 7);
}

// The sun's position is only a place to look from, here a near one: who takes it for a lamp's sees it.
static void make_volume_sun(Scene *scene, Random *random) {
    make_volume_spot(scene, random);
    Light *sun = &scene->lights[0];
    sun->kind = LIGHT_DIRECTIONAL;
    sun->position = glms_vec3_scale(sun->position, random_range(random, 0.3f, 0.4f));
}

// Casters in a row along one ray of light: their volumes lie in each other.
static void make_nested(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    vec3s lamp = beside(scene, random, 60, 90, random_range(random, 45, 55));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    for (int i = 0; i < 3; i++) {
        float height = 0.4f + 0.75f * (float)i, r = random_range(random, 0.45f, 0.6f);
        vec3s center = glms_vec3_scale(lamp, height / lamp.y);
        center.x += random_range(random, -0.25f, 0.25f);
        center.z += random_range(random, -0.25f, 0.25f);
        part_object(scene, i % 2 ? SHAPE_SPHERE : SHAPE_BOX, center, vec3_make(r, i % 2 ? r : 0.2f, r),
                    random_range(random, 0, 90), part_color(random));
    }
}

// Tall boxes under a steep camera, so that the upper edge of the picture cuts boxes and shadows.
static void make_towers(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 14, random);
    scene->camera.eye =
        part_orbit(vec3_make(0, 0.5f, 0), random_range(random, -35, 35), random_range(random, 45, 55), 9);
    scene->background = vec3_make(0.8f, 0.9f, 1);
    vec3s lamp = beside(scene, random, 40, 80, random_range(random, 40, 50));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    for (int i = 0; i < 3; i++) {
        float h = random_range(random, 0.5f, 1);
        part_object(scene, SHAPE_BOX,
                    vec3_make(-3.6f + 3.6f * (float)i, h, random_range(random, -3.5f, 0.5f)),
                    vec3_make(random_range(random, 0.3f, 0.5f), h, random_range(random, 0.3f, 0.5f)),
                    random_range(random, 0, 90), part_color(random));
    }
}

// Two plates behind the camera keep the light from it: the eye stands in two volumes.
static void make_eye_inside(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_box(scene, random_range(random, 0.5f, 0.8f), random);
    vec3s eye = scene->camera.eye, view = glms_vec3_normalize(glms_vec3_sub(scene->camera.target, eye));
    vec3s right = glms_vec3_normalize(glms_vec3_cross(view, vec3_make(0, 1, 0)));
    vec3s lamp = glms_vec3_sub(eye, glms_vec3_scale(view, random_range(random, 3, 4)));
    float side = random_int(random, 0, 1) ? 1 : -1, turn = glm_deg(atan2f(view.x, view.z));
    for (int i = 0; i < 2; i++) {
        vec3s plate = glms_vec3_lerp(eye, lamp, 0.3f + 0.2f * (float)i);
        plate = glms_vec3_add(plate, glms_vec3_scale(right, side * random_range(random, 0.1f, 0.3f)));
        plate.y += random_range(random, -0.12f, 0.12f);
        part_object(scene, SHAPE_BOX, plate, vec3_make(0.38f, random_range(random, 0.25f, 0.38f), 0.05f),
                    turn, part_color(random));
        side = -side;
    }
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
}

// A lamp below its casters: the volumes go up, half into an open sky, half onto a wall (one-sided, so that it
// casts none). The eye stands in the volume of a plate near the lamp.
static void make_into_sky(Scene *scene, Random *random) {
    part_begin(scene, random);
    scene->camera.eye =
        part_orbit(vec3_make(0, 1.5f, 0), random_range(random, -35, 35), random_range(random, 3, 8), 9);
    scene->camera.target = vec3_make(0, 2.2f, 0);
    vec3s lamp = beside(scene, random, 5, 30, 0);
    lamp = glms_vec3_scale(lamp, random_range(random, 0.5f, 0.6f));
    lamp.y = 0.1f;
    for (int i = 0; i < 2; i++) {
        float r = random_range(random, 0.35f, 0.5f);
        part_object(scene, SHAPE_BOX,
                    vec3_make(-1.8f + 3.6f * (float)i, random_range(random, 0.5f, 1.6f),
                              random_range(random, -0.5f, 0.5f)),
                    vec3_make(r, r, r), random_range(random, 0, 90), part_color(random));
    }
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 1, 0));
    vec3s to_eye = glms_vec3_sub(scene->camera.eye, lamp);
    part_object(scene, SHAPE_BOX, glms_vec3_lerp(lamp, scene->camera.eye, 0.2f), vec3_make(0.3f, 0.2f, 0.05f),
                glm_deg(atan2f(to_eye.x, to_eye.z)), part_color(random));
    Object *wall =
        part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(1, 1, 1), 0, part_color(random));
    float side = random_int(random, 0, 1) ? 1 : -1;
    mat4s placed = glms_translate_make(vec3_make(side * random_range(random, 2.7f, 3.3f), 3, -1.5f));
    wall->world_from_object =
        glms_scale(glms_rotate(placed, glm_rad(90), vec3_make(1, 0, 0)), vec3_make(3, 1, 3));
}

// How far the corners of the floor of make_short_sight lie in front of the camera: the least and the most.
static vec2s find_depths(const Camera *camera, float half) {
    vec3s view = glms_vec3_normalize(glms_vec3_sub(camera->target, camera->eye));
    vec2s depths = {{1e9f, 0}};
    for (int i = 0; i < 4; i++) {
        vec3s corner = vec3_make(i & 1 ? half : -half, 0, i & 2 ? half : -half);
        float depth = glms_vec3_dot(glms_vec3_sub(corner, camera->eye), view);
        depths = (vec2s){{fminf(depths.x, depth), fmaxf(depths.y, depth)}};
    }
    return depths;
}

// The camera's far plane lies close behind the floor: volumes go on, surfaces do not. Its near plane cuts the
// floor's nearest corner off, and hides a small box that is much nearer: who only clamps depths shows both.
static void make_short_sight(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 3, random);
    part_casters(scene, random);
    vec3s lamp = beside(scene, random, 25, 50, random_range(random, 35, 45));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    vec2s depths = find_depths(&scene->camera, 3);
    scene->camera.near_plane = depths.x + random_range(random, 0.8f, 1.1f);
    scene->camera.far_plane = depths.y + 0.05f;
    const float near = 0.3f * scene->camera.near_plane, half = 0.1f * near;
    vec3s view = glms_vec3_normalize(glms_vec3_sub(scene->camera.target, scene->camera.eye));
    vec3s right = glms_vec3_normalize(glms_vec3_cross(view, vec3_make(0, 1, 0)));
    vec3s place = glms_vec3_muladds(right, random_range(random, -0.25f, 0.25f) * near,
                                    glms_vec3_muladds(view, near, scene->camera.eye));
    part_object(scene, SHAPE_BOX, place, vec3_make(half, half, half), random_range(random, 0, 90),
                part_color(random));
}

// A fly close before the lamp, seen from near: its faces are tiny, its volume is not. A number above 0 that
// is small for a box is large for it.
static void make_fly(Scene *scene, Random *random) {
    const float half = random_range(random, 0.003f, 0.004f), away = 6 * half;
    part_begin(scene, random);
    vec3s lamp = beside(scene, random, 20, 60, random_range(random, 60, 75));
    lamp = glms_vec3_scale(lamp, random_range(random, 0.22f, 0.28f));
    vec3s fly = glms_vec3_sub(lamp, glms_vec3_scale(glms_vec3_normalize(lamp), away));
    part_object(scene, SHAPE_BOX, fly, vec3_make(half, half, half), random_range(random, 0, 90),
                part_color(random));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    vec3s view = glms_vec3_normalize(glms_vec3_sub(fly, scene->camera.eye));
    scene->camera.eye = glms_vec3_sub(fly, glms_vec3_scale(view, 16 * half));
    scene->camera.target = fly;
    scene->camera.near_plane = half;
}

// Open sheets under a steep camera: nothing casts a volume, and something is in the last rows of the picture.
static void make_sheets(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 14, random);
    scene->camera.eye =
        part_orbit(vec3_make(0, 0.5f, 0), random_range(random, -35, 35), random_range(random, 45, 55), 9);
    for (int i = 0; i < 2; i++) {
        vec3s middle = vec3_make(-3.2f + 6.4f * (float)i, 0.7f, random_range(random, -3.5f, 0.5f));
        Object *sheet = part_object(scene, SHAPE_PLANE, middle, vec3_make(1, 1, 1),
                                    random_range(random, -60, 60), part_color(random));
        sheet->world_from_object = glms_rotate(sheet->world_from_object, glm_rad(60), vec3_make(1, 0, 0));
        sheet->world_from_object = glms_scale(sheet->world_from_object, vec3_make(0.6f, 1, 0.7f));
    }
    vec3s lamp = beside(scene, random, 5, 80, random_range(random, 40, 70));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
}

// Boxes near the eye, and their shadows on a wall that is farther away than any length that one would type.
static void make_far_wall(Scene *scene, Random *random) {
    part_begin(scene, random);
    vec3s middle = vec3_make(0, 1, 0);
    float azimuth = random_range(random, -35, 35), side = random_int(random, 0, 1) ? 1 : -1;
    scene->camera.target = middle;
    scene->camera.eye = part_orbit(middle, azimuth, random_range(random, 2, 6), 9);
    scene->camera.far_plane = 130;
    for (int i = -1; i <= 1; i++) {
        vec3s center = part_orbit(middle, azimuth + 90, 0, 0.9f * (float)i);
        center.y += random_range(random, -0.5f, 0.5f);
        float r = random_range(random, 0.15f, 0.25f);
        part_object(scene, SHAPE_BOX, center, vec3_make(r, 1.5f * r, r), random_range(random, 0, 90),
                    part_color(random));
    }
    vec3s behind = part_orbit(middle, azimuth + 180, 0, random_range(random, 62, 70));
    Object *wall = part_object(scene, SHAPE_PLANE, behind, vec3_make(1, 1, 1), azimuth, part_color(random));
    wall->world_from_object = glms_scale(
        glms_rotate(wall->world_from_object, glm_rad(90), vec3_make(1, 0, 0)), vec3_make(90, 1, 60));
    float lamp = azimuth + side * random_range(random, 6, 9);
    part_light(scene, LIGHT_SPOT, part_orbit(middle, lamp, random_range(random, 3, 8), 6), middle);
}

// Each box has a side in whose plane the lamp lies, so that its light only grazes it.
static void make_grazing(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    vec3s lamp = beside(scene, random, 40, 80, random_range(random, 35, 45));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0));
    for (int i = 0; i < 10; i++) {
        bool across = random_int(random, 0, 1) == 1; // any of a box's four upright sides
        float side = random_int(random, 0, 1) ? 1 : -1;
        vec3s edge = vec3_make(-2.7f + 0.6f * (float)i, 0, random_range(random, -1.8f, 1.8f));
        vec3s along = glms_vec3_normalize(vec3_make(edge.x - lamp.x, 0, edge.z - lamp.z));
        vec3s half = vec3_make(random_range(random, 0.2f, 0.3f), random_range(random, 0.7f, 1.2f),
                               random_range(random, 0.2f, 0.3f));
        float aside = side * (across ? half.z : half.x);
        vec3s center = glms_vec3_add(edge, vec3_make(along.z * aside, half.y, -along.x * aside));
        part_object(scene, SHAPE_BOX, center, half, glm_deg(atan2f(along.x, along.z)) + (across ? 90 : 0),
                    part_color(random));
    }
}

const SceneMaker LAB_TABLE[] = {
    {"volume spot", make_volume_spot},
    {"volume sun", make_volume_sun},
    {"nested", make_nested},
    {"towers", make_towers},
    {"eye inside", make_eye_inside},
    {"into the sky", make_into_sky},
    {"short sight", make_short_sight},
    {"grazing", make_grazing},
    {"open sheets", make_sheets},
    {"far wall", make_far_wall},
    {"fly", make_fly},
    {0},
};
