#include "diagnose/first_frame.h"

#include "exam/frame_score.h"
#include "score/score.h"

#include <string.h>

static const double SECONDS = 2, PATIENCE = 5; // of processor time, and of the clock

bool first_frame_is_right(const CheckResult *check, const Exam *exam, int c, const WorkerClient *student) {
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
