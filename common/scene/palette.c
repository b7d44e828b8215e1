#include "scene/palette.h"

#include "scene/check.h"
#include "scene/count.h"

enum { MAX_PAINTS = 6 };

static const vec3s pale[] = {{{0.87f, 0.84f, 0.78f}}, {{0.74f, 0.79f, 0.82f}}, {{0.78f, 0.66f, 0.58f}}},
                   clear[] = {{{0.86f, 0.42f, 0.30f}}, {{0.24f, 0.55f, 0.62f}}, {{0.92f, 0.70f, 0.33f}},
                              {{0.42f, 0.47f, 0.72f}}, {{0.50f, 0.66f, 0.43f}}, {{0.70f, 0.45f, 0.58f}}},
                   background = {{0.11f, 0.14f, 0.20f}};

// Paints in the order in which they are used, again from the first when all are.
typedef struct Paints {
    vec3s colors[MAX_PAINTS];
    int count, used;
} Paints;

// In an order that `random` shuffles; NULL: as they stand.
static Paints paints_of(const vec3s *colors, int count, Random *random) {
    Paints paints = {.count = count};
    INVARIANT(count <= MAX_PAINTS);
    for (int i = 0; i < count; i++) {
        const int place = random ? random_int(random, 0, i) : i;
        paints.colors[i] = paints.colors[place];
        paints.colors[place] = colors[i];
    }
    return paints;
}

// More or less dark as a whole: the ratio of the channels tells two colours apart.
static vec3s paints_next(Paints *paints, Random *random) {
    const vec3s color = paints->colors[paints->used++ % paints->count];
    return random ? glms_vec3_scale(color, random_range(random, 0.85f, 1)) : color;
}

static float plane_area(const Object *object) {
    return object->shape == SHAPE_PLANE ? glms_vec3_norm(glms_vec3(object->world_from_object.col[0])) *
                                              glms_vec3_norm(glms_vec3(object->world_from_object.col[2]))
                                        : 0;
}

// Floors and walls: a plane that is small beside the largest one is a caster.
static bool receives(const Scene *scene, int i) {
    float largest = 0;
    for (int other = 0; other < scene->object_count; other++)
        largest = fmaxf(largest, plane_area(&scene->objects[other]));
    return largest > 0 && plane_area(&scene->objects[i]) >= 0.2f * largest;
}

// The object before `i`, of the same kind, that has its colour; -1 when there is none.
static int first_of_its_color(const Scene *scene, int i) {
    for (int before = 0; before < i; before++)
        if (receives(scene, before) == receives(scene, i) &&
            glms_vec3_eqv(scene->objects[before].color, scene->objects[i].color))
            return before;
    return -1;
}

static bool is_own(vec3s color) {
    return glms_vec3_max(color) < PALETTE_DARKEST;
}

static void paint(Scene *scene, Random *random, bool own_stays) {
    const Scene drawn = *scene;
    Paints floors = paints_of(pale, COUNT(pale), random), casters = paints_of(clear, COUNT(clear), random);
    for (int i = 0; i < scene->object_count; i++) {
        const int before = first_of_its_color(&drawn, i);
        if (!own_stays || !is_own(drawn.objects[i].color))
            scene->objects[i].color = before >= 0
                                          ? scene->objects[before].color
                                          : paints_next(receives(&drawn, i) ? &floors : &casters, random);
    }
}

void palette_vary(Scene *scene, Random *random) {
    paint(scene, random, true);
}

void palette_apply(Scene *scene) {
    paint(scene, NULL, false);
    scene->background = background;
}
