#include "exam/exam_draw.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// Sizes that students write down are multiples of 8: no frame has such a side.
static int uneven(int side) {
    return side % 8 ? side : side + 3;
}

static void draw_size(Draw *draw, bool large) {
    Random *random = &draw->random;
    if (large) {
        draw->width = uneven(random_int(random, 645, 700));
        draw->height = uneven(random_int(random, 485, 520));
        return;
    }
    float pixels = random_range(random, 14000, 30000), aspect = exp2f(random_range(random, -0.415f, 1));
    draw->width = uneven((int)sqrtf(pixels * aspect));
    draw->height = uneven((int)sqrtf(pixels / aspect));
}

Draw draw_begin_check(const Rubric *rubric, uint64_t seed, int c) {
    Draw draw = {.random = {seed ^ (0x517cc1b727220a95u * (uint64_t)(c + 1))}};
    draw.random.state ^= (uint64_t)atoi(rubric->id) << 32;
    draw_size(&draw, rubric->checks[c].large);
    draw.start = random_int(&draw.random, 0, 59); // a multiple of every possible number of choices
    return draw;
}

static float draw_knob(Draw *draw, const KnobChoice *knob, int n) {
    if (knob->choice_count > 0)
        return knob->choices[(draw->start + n) % knob->choice_count];
    return knob->whole ? (float)random_int(&draw->random, (int)knob->low, (int)knob->high)
                       : random_range(&draw->random, knob->low, knob->high);
}

const char *draw_scene_name(const Draw *draw, const Check *check, int n) {
    return check->scenes[(draw->start + n) % check->scene_count];
}

bool draw_request(Draw *draw, Request *request, const Check *check, int n) {
    *request = (Request){.magic = PROTOCOL_MAGIC,
                         .width = draw->width,
                         .height = draw->height,
                         .fresh = 1,
                         .knob_count = check->knob_count};
    snprintf(request->view, sizeof request->view, "%s", check->view);
    for (int i = 0; i < check->knob_count; i++) {
        snprintf(request->knobs[i].name, sizeof request->knobs[i].name, "%s", check->knobs[i].name);
        request->knobs[i].value = draw_knob(draw, &check->knobs[i], n);
    }
    return scene_make(&request->scene, draw_scene_name(draw, check, n), &draw->random);
}
