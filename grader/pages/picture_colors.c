#include "pages/picture_colors.h"

enum { PALE = 3, CLEAR = 6 };

static const vec3s pale[PALE] = {{{0.87f, 0.84f, 0.78f}}, {{0.74f, 0.79f, 0.82f}}, {{0.83f, 0.76f, 0.70f}}},
                   clear[CLEAR] = {{{0.86f, 0.42f, 0.30f}}, {{0.24f, 0.55f, 0.62f}}, {{0.92f, 0.70f, 0.33f}},
                                   {{0.42f, 0.47f, 0.72f}}, {{0.50f, 0.66f, 0.43f}}, {{0.70f, 0.45f, 0.58f}}},
                   background = {{0.11f, 0.14f, 0.20f}};

// The object before `i`, of the same kind of shape, that has its colour; -1 when there is none.
static int first_of_its_color(const Scene *scene, int i) {
    const Object *object = &scene->objects[i];
    for (int before = 0; before < i; before++) {
        const Object *other = &scene->objects[before];
        if ((other->shape == SHAPE_PLANE) == (object->shape == SHAPE_PLANE) &&
            glms_vec3_eqv(other->color, object->color))
            return before;
    }
    return -1;
}

void picture_colors_apply(Scene *scene) {
    const Scene drawn = *scene;
    int planes = 0, casters = 0;
    for (int i = 0; i < scene->object_count; i++) {
        const int before = first_of_its_color(&drawn, i);
        scene->objects[i].color = before >= 0                             ? scene->objects[before].color
                                  : drawn.objects[i].shape == SHAPE_PLANE ? pale[planes++ % PALE]
                                                                          : clear[casters++ % CLEAR];
    }
    scene->background = background;
}
