// Chooses among the recorded frames of an exam, and reads the one that is looked at.
#include "window/recorded.h"

#include "exam/exam_file.h"
#include "exam/exam_seeds.h"
#include "exam/handed_out.h"
#include "scene/check.h"

#include <string.h>

bool recorded_begin(Recorded *recorded, const Rubric *rubric) {
    *recorded = (Recorded){.rubric = rubric};
    if (!handed_out_alone() || rubric->check_count == 0)
        return check_fail("no reference here: the solutions are not handed out");
    recorded->seed_count = exam_seeds_list(recorded->seeds, RECORDED_MOST_SEEDS);
    return recorded->seed_count > 0;
}

void recorded_end(Recorded *recorded) {
    image_destroy(&recorded->frame.reference);
    *recorded = (Recorded){0};
}

static bool open_frame(Recorded *recorded, int seed, int check, int variant) {
    recorded->open =
        exam_file_reference(recorded->rubric, recorded->seeds[seed], check, variant, &recorded->frame);
    recorded->seed = seed;
    recorded->check = check;
    recorded->variant = variant;
    return recorded->open;
}

// How well a check fits what is looked at.
static int fitness(const Check *check, const char *view, const char *scene) {
    const bool same_view = strcmp(check->view, view) == 0;
    return same_view && rubric_uses_scene(check, scene) ? 3
           : same_view                                  ? 2
           : strcmp(check->view, VIEW_PICTURE) == 0     ? 1
                                                        : 0;
}

// Of several that fit as well the last one: it asks for most.
static int choose_check(const Rubric *rubric, const char *view, const char *scene) {
    int best = 0;
    for (int c = 1; c < rubric->check_count; c++)
        if (fitness(&rubric->checks[c], view, scene) >= fitness(&rubric->checks[best], view, scene))
            best = c;
    return best;
}

static int choose_seed(const Recorded *recorded, uint64_t seed) {
    for (int i = 0; i < recorded->seed_count; i++)
        if (recorded->seeds[i] == seed)
            return i;
    return 0;
}

bool recorded_open(Recorded *recorded, int check, const char *view, const char *scene, uint64_t seed) {
    if (recorded->seed_count == 0)
        return check_fail("no reference here: the solutions are not handed out");
    const int chosen = check >= 0 ? check : choose_check(recorded->rubric, view, scene),
              number = choose_seed(recorded, seed);
    for (int n = 0; n < recorded->rubric->checks[chosen].variants; n++)
        if (!open_frame(recorded, number, chosen, n))
            return false;
        else if (strcmp(recorded->frame.scene, scene) == 0)
            return true;
    return open_frame(recorded, number, chosen, 0);
}

bool recorded_step_check(Recorded *recorded, int direction) {
    const int count = recorded->rubric->check_count;
    return open_frame(recorded, recorded->seed, (recorded->check + direction + count) % count, 0);
}

bool recorded_step_variant(Recorded *recorded, int direction) {
    const int variants = recorded->rubric->checks[recorded->check].variants,
              count = variants * recorded->seed_count,
              next = (recorded->seed * variants + recorded->variant + direction + count) % count;
    return open_frame(recorded, next / variants, recorded->check, next % variants);
}
