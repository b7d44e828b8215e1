// Draws a lab's exam when it is needed, or before that in a thread, and forgets it when another seed is asked
// for.
#include "exam/lab_exam.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "exam/exam_file.h"
#include "exam/handed_out.h"
#include "predict/predictions.h"
#include "scene/random.h"

#include <stdio.h>
#include <stdlib.h>

bool lab_exam_open(LabExam *examiner, const char *id) {
    char folder[FILES_PATH];
    *examiner = (LabExam){0};
    return (places_find_lab(folder, id) || check_fail("there is no lab \"%s\"", id)) &&
           rubric_load(&examiner->rubric, folder) && predictions_fit(&examiner->rubric);
}

static void forget_pictures(LabExam *examiner) {
    if (examiner->exam)
        exam_destroy(examiner->exam);
    free(examiner->exam);
    examiner->exam = NULL;
}

// A class has hundreds of seeds: none of them may leave somebody without a grade.
static bool draw_exam(LabExam *examiner, Exam *exam, const GradeOptions *options) {
    enum { SEEDS = 4 };
    uint64_t seed = options->seed;
    Random next = {seed};
    for (int i = 0; i < (options->hidden ? SEEDS : 1); i++, seed = random_next(&next)) {
        check_clear();
        if (exam_create(exam, &examiner->rubric, &examiner->painters, seed))
            return true;
        if (!exam->scarce)
            return false;
    }
    return false;
}

static Exam *make_exam(LabExam *examiner, const GradeOptions *options) {
    Exam *exam = calloc(1, sizeof *exam);
    INVARIANT(exam);
    if (handed_out_alone() ? exam_file_load(exam, &examiner->rubric, options->seed)
                           : draw_exam(examiner, exam, options))
        return exam;
    free(exam);
    return NULL;
}

static void prepare(LabExam *examiner, const GradeOptions *options) {
    forget_pictures(examiner);
    examiner->painters.rubric = &examiner->rubric;
    examiner->painters.context = options->context;
}

static void *make_early(void *context) {
    LabExam *examiner = context;
    examiner->early.exam = make_exam(examiner, &examiner->early.options);
    snprintf(examiner->early.why, sizeof examiner->early.why, "%.599s", check_message());
    return NULL;
}

void lab_exam_begin(LabExam *examiner, const GradeOptions *options) {
    EarlyExam *early = &examiner->early;
    if (early->running || handed_out_alone() || (examiner->exam && examiner->seed == options->seed))
        return;
    prepare(examiner, options);
    // The worker dies with the thread that has started it: so that is ours.
    early->options = *options;
    early->running = painters_start(&examiner->painters) &&
                     pthread_create(&early->thread, NULL, make_early, examiner) == 0;
    check_clear();
}

// The exam that was begun, once it is drawn; NULL: it could not be.
static Exam *wait_early(EarlyExam *early) {
    pthread_join(early->thread, NULL);
    Exam *exam = early->exam;
    early->exam = NULL;
    early->running = false;
    return exam;
}

// What it is still drawing is not waited for: its worker is told that the time is over.
static void forget_early(LabExam *examiner) {
    if (!examiner->early.running)
        return;
    examiner->painters.client.process.cancelled = true;
    Exam *exam = wait_early(&examiner->early);
    if (exam)
        exam_destroy(exam);
    free(exam);
    worker_client_stop(&examiner->painters.client);
}

Exam *lab_exam_exam(LabExam *examiner, const GradeOptions *options) {
    if (examiner->early.running && examiner->early.options.seed == options->seed) {
        examiner->exam = wait_early(&examiner->early);
        if (!examiner->exam)
            check_fail("%s", examiner->early.why);
    } else if (!examiner->exam || examiner->seed != options->seed) {
        forget_early(examiner);
        prepare(examiner, options);
        examiner->exam = make_exam(examiner, options);
    }
    examiner->seed = options->seed;
    return examiner->exam;
}

void lab_exam_trim(LabExam *examiner) {
    static const size_t MOST = (size_t)128 << 20;
    if (examiner->exam)
        exam_forget_late(examiner->exam, MOST);
}

void lab_exam_rest(LabExam *examiner) {
    worker_client_stop(&examiner->painters.client);
}

void lab_exam_forget(LabExam *examiner) {
    forget_early(examiner);
    forget_pictures(examiner);
    painters_destroy(&examiner->painters);
}

void lab_exam_close(LabExam *examiner) {
    lab_exam_forget(examiner);
    rubric_destroy(&examiner->rubric);
}
