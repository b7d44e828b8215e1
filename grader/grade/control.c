#include "grade/control.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "score/score.h"

#include <stdio.h>

static bool take_ours(const char *folder, const Rubric *rubric, const Jail *jail) {
    static char log[COMPILE_LOG];
    if (lab_folder_submission(folder, rubric, rubric->folder, jail, log))
        return true;
    char why[600];
    snprintf(why, sizeof why, "%.590s", log[0] ? log : check_message());
    check_clear();
    return check_fail("our own lab %s does not compile in the jail, so the submission is not to blame: %s",
                      rubric->id, why);
}

bool control_compiles(const Rubric *rubric, const Jail *jail) {
    char folder[FILES_PATH];
    if (!files_make_temporary(folder))
        return false;
    const bool ok = take_ours(folder, rubric, jail);
    files_remove(folder);
    return ok;
}

// A few pixels may differ: the jail's processes are compiled and their shaders kept in other ways than ours.
static bool is_same(const Image *theirs, const Image *ours) {
    enum { FEW = 1000 };
    return theirs->width == ours->width && theirs->height == ours->height &&
           score_count(theirs, ours) <= image_bytes(ours) / 4 / FEW;
}

static bool draw_ours(Exam *exam, WorkerClient *client) {
    static Reply reply;
    Image image = {0};
    const Variant *variant = &exam->variants[0][0];
    bool ok = worker_client_draw(client, &variant->request, &image, &reply) == DRAW_OK ||
              check_fail("our own lab %s cannot be drawn in the jail, so the submission is not to blame: %s",
                         exam->rubric->id, reply.message);
    ok = ok && (is_same(&image, &variant->reference) ||
                check_fail("our own lab %s is drawn wrong in the jail, so the submission is not to blame: "
                           "does its driver (%s) need what the jail forbids? Try --context egl or osmesa",
                           exam->rubric->id, reply.renderer));
    image_destroy(&image);
    return ok;
}

bool control_draws(LabExam *examiner, Exam *exam, const WorkerClient *student) {
    static WorkerClient client;
    if (examiner->control)
        return true;
    client = (WorkerClient){.trust = student->trust,
                            .jail = student->jail,
                            .context = student->context,
                            .quick_shaders = true,
                            .seconds = student->seconds,
                            .patience = student->patience};
    if (!files_make_temporary(client.folder))
        return false;
    examiner->control = take_ours(client.folder, exam->rubric, student->jail) && draw_ours(exam, &client);
    worker_client_stop(&client);
    files_remove(client.folder);
    return examiner->control;
}
