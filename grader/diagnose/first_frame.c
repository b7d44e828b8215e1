#include "diagnose/first_frame.h"

#include "exam/frame_score.h"
#include "score/score.h"

#include <string.h>

static const double SECONDS = 2, PATIENCE = 5; // of processor time, and of the clock

static bool is_right(const CheckResult *check, const Exam *exam, int c, const WorkerClient *student) {
    static WorkerClient worker;
    static Reply reply;
    const Variant *variant = &exam->variants[c][check->worst];
    Image picture = {0};
    worker = (WorkerClient){.trust = TRUST_NOBODY,
                            .jail = student->jail,
                            .context = student->context,
                            .quick_shaders = true,
                            .seconds = SECONDS,
                            .patience = PATIENCE};
    memcpy(worker.folder, student->folder, sizeof worker.folder);
    const bool right =
        worker_client_draw(&worker, &variant->request, &picture, &reply) == DRAW_OK &&
        frame_score(&picture, &reply.facts, variant, &variant->reference).share >= SCORE_PASSED;
    worker_client_stop(&worker);
    image_destroy(&picture);
    return right;
}

bool first_frame_find(const LabResult *result, const Exam *exam, const bool failed[],
                      const WorkerClient *student) {
    int order[EXAM_MAX_VARIANTS];
    exam_order(exam, 0, order);
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        const bool is_first = c == 0 && check->worst == order[0];
        if (failed[c] && check->yours[check->worst].rgba && !is_first)
            return is_right(check, exam, c, student);
    }
    return false;
}
