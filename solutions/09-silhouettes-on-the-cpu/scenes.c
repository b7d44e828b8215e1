// Scenes of silhouettes: casters that are closed or open, convex or not, and an eye in their shadows.
#include "scene/scene_parts.h"

// One lamp of six stands straight above, and every second sun: then the light goes along what is upright.
enum { LAMP_ABOVE = 5, SUN_ABOVE = 1 };

static vec3s jitter(Random *random, float most) {
    float x = random_range(random, -most, most), y = random_range(random, -most, most);
    return vec3_make(x, y, random_range(random, -most, most));
}

// A lamp beside the casters, at times straight above them; or a sun in its direction, which is a difference.
static void add_light(Scene *scene, Random *random, LightKind kind) {
    float camera = glm_deg(atan2f(scene->camera.eye.x, scene->camera.eye.z));
    float side = random_int(random, 0, 1) ? 1 : -1, elevation = random_range(random, 35, 65);
    bool above = random_int(random, 0, kind == LIGHT_DIRECTIONAL ? SUN_ABOVE : LAMP_ABOVE) == 0;
    vec3s place = part_orbit(vec3_make(0, 0, 0), camera + side * random_range(random, 35, 80), elevation,
                             random_range(random, 6, 9));
    place = above ? vec3_make(0, place.y, 0) : place;
    vec3s aside = vec3_make(0, 0, 0);
    if (kind == LIGHT_DIRECTIONAL)
        aside =
            vec3_make(random_range(random, -3, 3), random_range(random, -2, 2), random_range(random, -3, 3));
    part_light(scene, kind, glms_vec3_add(place, aside), aside);
}

// Leans an object over by degrees about its own x axis.
static void lean(Object *object, float degrees, vec3s half_size) {
    mat4s *placed = &object->world_from_object;
    *placed = glms_scale(*placed, vec3_make(1 / half_size.x, 1 / half_size.y, 1 / half_size.z));
    *placed = glms_scale(glms_rotate(*placed, glm_rad(degrees), vec3_make(1, 0, 0)), half_size);
}

static void add_arch(Scene *scene, Random *random, vec3s center) {
    vec3s half = vec3_make(random_range(random, 0.5f, 0.7f), random_range(random, 0.5f, 0.8f),
                           random_range(random, 0.15f, 0.4f));
    center.y += half.y;
    part_object(scene, SHAPE_ARCH, center, half, random_range(random, -60, 60), part_color(random));
}

// An arch, which is not convex, a box that leans, and a ball, in any order from left to right.
static void make_casters(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    int first = random_int(random, 0, 2);
    for (int i = 0; i < 3; i++) {
        vec3s center =
            vec3_make(1.5f * (float)((i + first) % 3) - 1.5f, 0, random_range(random, -0.7f, 0.7f));
        if (i == 0) {
            add_arch(scene, random, center);
            continue;
        }
        float r = random_range(random, 0.4f, 0.55f);
        vec3s half = vec3_make(r, i == 1 ? random_range(random, 0.3f, 0.6f) : r, r);
        center.y = random_range(random, 0.8f, 1.2f);
        Object *object = part_object(scene, i == 1 ? SHAPE_BOX : SHAPE_SPHERE, center, half,
                                     random_range(random, 0, 90), part_color(random));
        lean(object, random_range(random, -50, 50), half);
    }
}

static void make_lamp(Scene *scene, Random *random) {
    make_casters(scene, random);
    add_light(scene, random, random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_POINT);
}

static void make_sun(Scene *scene, Random *random) {
    make_casters(scene, random);
    add_light(scene, random, LIGHT_DIRECTIONAL);
}

// Two boxes of whose faces three are lit, turned so that the edge between +x and -z is nearest to the light:
// the mesh begins with it. Few edges and no floor with its long diagonal, so that one that stays is a large
// part of them.
static void make_boxes(Scene *scene, Random *random) {
    part_begin(scene, random);
    LightKind kind = random_int(random, 0, 1) ? LIGHT_DIRECTIONAL : LIGHT_POINT;
    float side = random_int(random, 0, 1) ? 1 : -1;
    float azimuth =
        glm_deg(atan2f(scene->camera.eye.x, scene->camera.eye.z)) + side * random_range(random, 45, 80);
    vec3s place = part_orbit(vec3_make(0, 0, 0), azimuth, random_range(random, 35, 55), 8);
    for (int i = 0; i < 2; i++) {
        vec3s half = vec3_make(random_range(random, 0.6f, 0.8f), random_range(random, 0.5f, 0.7f),
                               random_range(random, 0.6f, 0.8f));
        vec3s center = vec3_make(2.2f * (float)i - 1.1f, half.y + random_range(random, 0.2f, 0.6f),
                                 random_range(random, -0.5f, 0.5f));
        vec3s toward = kind == LIGHT_DIRECTIONAL ? place : glms_vec3_sub(place, center);
        float turn = glm_deg(atan2f(toward.x, toward.z)) - 90 - random_range(random, 25, 65);
        part_object(scene, SHAPE_BOX, center, half, turn, part_color(random));
    }
    part_light(scene, kind, place, vec3_make(0, 0, 0));
}

// Open sheets; some look to the light, and some away from it.
static void make_sheets(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    for (int i = 0; i < 4; i++) {
        vec3s middle = vec3_make(1.3f * (float)i - 1.95f, random_range(random, 0.7f, 1.1f),
                                 random_range(random, -0.8f, 0.8f));
        vec3s half = vec3_make(random_range(random, 0.35f, 0.5f), 1, random_range(random, 0.35f, 0.5f));
        Object *sheet =
            part_object(scene, SHAPE_PLANE, middle, half, random_range(random, -60, 60), part_color(random));
        lean(sheet, i % 2 ? random_range(random, 60, 110) : random_range(random, -70, 30), half);
    }
    add_light(scene, random, random_int(random, 0, 1) ? LIGHT_DIRECTIONAL : LIGHT_POINT);
}

// Behind the camera or straight above it, so that what hangs between takes the light from the eye.
static vec3s behind_eye(const Scene *scene, Random *random) {
    vec3s eye = scene->camera.eye, view = glms_vec3_normalize(glms_vec3_sub(scene->camera.target, eye));
    vec3s back = random_int(random, 0, 2) ? glms_vec3_negate(view) : vec3_make(0, 1, 0);
    back = glms_vec3_normalize(glms_vec3_add(back, jitter(random, 0.15f)));
    return glms_vec3_muladds(back, random_range(random, 3, 4), eye);
}

// A lamp there, or a sun that shines as the lamp does at the eye.
static void light_eye(Scene *scene, Random *random, vec3s place) {
    vec3s to_eye = glms_vec3_sub(scene->camera.eye, place);
    if (random_int(random, 0, 1)) {
        vec3s aside = jitter(random, 2);
        part_light(scene, LIGHT_DIRECTIONAL, aside, glms_vec3_add(aside, to_eye));
    } else {
        part_light(scene, random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_POINT, place, scene->camera.eye);
    }
}

// A caster on the way from the light to the eye, at a part of it, aside by this vector. An arch stands so
// that the way leads through both of its legs.
static void hang(Scene *scene, Random *random, vec3s place, float part, vec3s aside) {
    vec3s eye = scene->camera.eye, way = glms_vec3_normalize(glms_vec3_sub(eye, place));
    static const Shape shapes[] = {SHAPE_BOX, SHAPE_SPHERE, SHAPE_ARCH, SHAPE_PLANE};
    Shape shape = shapes[random_int(random, 0, 3)];
    float r = random_range(random, 0.28f, 0.36f);
    vec3s half = shape == SHAPE_BOX    ? vec3_make(r, 0.07f, r)
                 : shape == SHAPE_ARCH ? vec3_make(0.16f, 0.4f, r)
                                       : vec3_make(r, r, r);
    vec3s center = glms_vec3_add(glms_vec3_lerp(place, eye, part), aside);
    // The axes of the caster: a flat one lies across the way, an arch has it for its x axis.
    vec3s across = glms_vec3_normalize(glms_vec3_cross(way, vec3_make(0.3f, 0.1f, 1)));
    vec3s third = glms_vec3_cross(across, way);
    bool along_x = shape == SHAPE_ARCH;
    if (along_x)
        center = glms_vec3_muladds(across, 0.3f * half.y, center);
    mat4s turned = glms_mat4_identity();
    turned.col[0] = glms_vec4(along_x ? way : third, 0);
    turned.col[1] = glms_vec4(along_x ? across : way, 0);
    turned.col[2] = glms_vec4(along_x ? glms_vec3_cross(way, across) : glms_vec3_cross(third, way), 0);
    if (shape == SHAPE_PLANE && random_int(random, 0, 1)) { // from behind
        turned.col[1] = glms_vec4_negate(turned.col[1]);
        turned.col[2] = glms_vec4_negate(turned.col[2]);
    }
    Object *object = part_object(scene, shape, center, half, 0, part_color(random));
    object->world_from_object = glms_scale(glms_mat4_mul(glms_translate_make(center), turned), half);
}

static void shuffle(Scene *scene, Random *random) {
    for (int i = scene->object_count - 1; i > 0; i--) {
        int k = random_int(random, 0, i);
        Object object = scene->objects[i];
        scene->objects[i] = scene->objects[k];
        scene->objects[k] = object;
    }
}

// One to three casters keep the light from the eye. One more hangs beyond the lamp, and what the eye sees
// lies on the same line, too.
static void make_eye(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    vec3s place = behind_eye(scene, random);
    int count = random_int(random, 1, 3);
    for (int i = 0; i < count; i++)
        hang(scene, random, place, 0.35f + 0.12f * (float)i, jitter(random, 0.06f));
    hang(scene, random, place, -0.3f, jitter(random, 0.02f));
    light_eye(scene, random, place);
    shuffle(scene, random);
    scene->camera.near_plane = random_range(random, 0.015f, 0.03f);
}

// A wide sheet on the way from the eye to the light, so far away, leans by `lean` (radians): some of its
// corners lie before the eye, others behind it. `turned` by half a turn those are others.
static void add_roof(Scene *scene, Random *random, vec3s place, vec3s axis, float lean, float away,
                     bool turned) {
    vec3s eye = scene->camera.eye, back = glms_vec3_normalize(glms_vec3_sub(place, eye));
    vec3s x = glms_vec3_normalize(glms_vec3_cross(axis, back)), y = glms_vec3_rotate(back, lean, x);
    vec3s half = vec3_make(random_range(random, 1.1f, 1.6f), 1, random_range(random, 1.1f, 1.6f));
    vec3s center = glms_vec3_muladds(back, away, eye);
    center = glms_vec3_muladds(x, random_range(random, 0.2f, 0.4f), center); // past the diagonal
    if (turned)
        x = glms_vec3_negate(x);
    mat4s axes = glms_mat4_identity();
    axes.col[0] = glms_vec4(x, 0);
    axes.col[1] = glms_vec4(y, 0);
    axes.col[2] = glms_vec4(glms_vec3_cross(x, y), 0);
    Object *sheet = part_object(scene, SHAPE_PLANE, center, half, 0, part_color(random));
    sheet->world_from_object = glms_scale(glms_mat4_mul(glms_translate_make(center), axes), half);
}

// Two of them close to the eye, in whose corners it does not lie alike, and one whose volume may end before
// it. The light is behind the camera.
static void make_roofs(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    vec3s eye = scene->camera.eye, view = glms_vec3_normalize(glms_vec3_sub(scene->camera.target, eye));
    vec3s back = glms_vec3_normalize(glms_vec3_sub(jitter(random, 0.15f), view));
    vec3s place = glms_vec3_muladds(back, random_range(random, 3, 4), eye), axis = jitter(random, 1);
    float lean = glm_rad(random_range(random, 34, 42));
    add_roof(scene, random, place, axis, lean, 0.15f, false);
    add_roof(scene, random, place, axis, lean, 0.27f, true);
    add_roof(scene, random, place, axis, lean, 1, random_int(random, 0, 1));
    light_eye(scene, random, place);
    shuffle(scene, random);
    scene->camera.near_plane = random_range(random, 0.015f, 0.03f);
}

// The near plane lies far before the eye, and cuts volumes; the eye is in one of them at most.
static void make_near_cut(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    vec3s eye = scene->camera.eye, view = glms_vec3_normalize(glms_vec3_sub(scene->camera.target, eye));
    vec3s right = glms_vec3_normalize(glms_vec3_cross(view, vec3_make(0, 1, 0)));
    vec3s up = glms_vec3_cross(right, view);
    vec3s place = glms_vec3_muladds(view, -random_range(random, 3, 4), eye);
    place = glms_vec3_muladds(up, random_range(random, 0, 0.6f), place);
    for (int i = 0; i < 3; i++) {
        float angle = glm_rad(random_range(random, 90.0f * (float)i, 90.0f * (float)i + 60));
        float away = random_range(random, 0.4f, 0.5f);
        vec3s aside = glms_vec3_muladds(right, away * cosf(angle), glms_vec3_scale(up, away * sinf(angle)));
        hang(scene, random, place, 0.4f + 0.1f * (float)i, aside);
    }
    light_eye(scene, random, place);
    scene->camera.near_plane = random_range(random, 2.5f, 4);
}

const SceneMaker LAB_TABLE[] = {
    {"edges lamp", make_lamp},          {"edges sun", make_sun},
    {"edges boxes", make_boxes},        {"edges sheets", make_sheets},
    {"eye in volumes", make_eye},       {"roofs over the eye", make_roofs},
    {"near plane cuts", make_near_cut}, {0},
};
