#include "tests/helpers/witness.h"

#include "base/places.h"

// cmocka wants these first.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "scene/check.h"
#include "compile/rubric_file.h"

// Draws, and returns what the solution says of it: "" when all is well.
static const char *draw(const char *id, Request *request, Image *image) {
    char folder[FILES_PATH];
    Rubric rubric;
    static Reply reply;
    assert_true(places_find_lab(folder, id) && rubric_load(&rubric, folder));
    Painters painters = {.rubric = &rubric};
    const Painter *solution = painters_get(&painters, (Solved){SOLVED_ALL, NULL}, NULL);
    assert_non_null(solution);
    assert_true(painters_draw(&painters, solution, request, image, &reply));
    painters_destroy(&painters);
    rubric_destroy(&rubric);
    return reply.message;
}

Image witness_draw(const char *id, const Scene *scene, const char *view, int width, int height,
                   const WitnessKnob *knobs, int knob_count) {
    Image image = {0};
    static Request request;
    request = (Request){.magic = PROTOCOL_MAGIC, .width = width, .height = height, .knob_count = knob_count};
    request.scene = *scene;
    snprintf(request.view, sizeof request.view, "%s", view);
    for (int i = 0; i < knob_count; i++) {
        snprintf(request.knobs[i].name, sizeof request.knobs[i].name, "%s", knobs[i].name);
        request.knobs[i].value = knobs[i].value;
    }
    assert_string_equal(draw(id, &request, &image), "");
    return image;
}

void witness_refuses(const char *id, const Scene *scene, const char *words) {
    Image image = {0};
    static Request request;
    request = (Request){.magic = PROTOCOL_MAGIC, .width = 64, .height = 48, .scene = *scene};
    snprintf(request.view, sizeof request.view, "%s", VIEW_PICTURE);
    assert_non_null(strstr(draw(id, &request, &image), words));
    image_destroy(&image);
}

bool witness_cuts(const WitnessPlate *plates, int count, vec3s point, vec3s end, float margin) {
    for (int i = 0; i < count; i++) {
        const WitnessPlate *plate = &plates[i];
        float t = (plate->center.z - point.z) / (end.z - point.z);
        vec3s at = glms_vec3_lerp(point, end, t);
        if (t > 0 && t < 1 && fabsf(at.x - plate->center.x) < plate->half + margin &&
            fabsf(at.y - plate->center.y) < plate->half + margin)
            return true;
    }
    return false;
}
