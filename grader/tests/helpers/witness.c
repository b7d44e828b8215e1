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

Image witness_draw(const char *id, const Scene *scene, const char *view, int width, int height,
                   const WitnessKnob *knobs, int knob_count) {
    char folder[FILES_PATH];
    Rubric rubric;
    Image image = {0};
    static Reply reply;
    static Request request;
    assert_true(places_find_lab(folder, id) && rubric_load(&rubric, folder));
    Painters painters = {.rubric = &rubric};
    request = (Request){.magic = PROTOCOL_MAGIC, .width = width, .height = height, .knob_count = knob_count};
    request.scene = *scene;
    snprintf(request.view, sizeof request.view, "%s", view);
    for (int i = 0; i < knob_count; i++) {
        snprintf(request.knobs[i].name, sizeof request.knobs[i].name, "%s", knobs[i].name);
        request.knobs[i].value = knobs[i].value;
    }
    const Painter *solution = painters_get(&painters, (Solved){SOLVED_ALL, NULL}, NULL);
    assert_non_null(solution);
    assert_true(painters_draw(&painters, solution, &request, &image, &reply));
    assert_string_equal(reply.message, "");
    painters_destroy(&painters);
    rubric_destroy(&rubric);
    return image;
}
