#include "exam/lab_exam.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "exam/exam_file.h"
#include "exam/handed_out.h"
#include "predict/predictions.h"
#include "scene/random.h"

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

Exam *lab_exam_exam(LabExam *examiner, const GradeOptions *options) {
    if (examiner->exam && examiner->seed == options->seed)
        return examiner->exam;
    forget_pictures(examiner);
    examiner->painters.rubric = &examiner->rubric;
    examiner->painters.context = options->context;
    Exam *exam = calloc(1, sizeof *exam);
    INVARIANT(exam);
    if (handed_out_alone() ? exam_file_load(exam, &examiner->rubric, options->seed)
                           : draw_exam(examiner, exam, options)) {
        examiner->seed = options->seed;
        return examiner->exam = exam;
    }
    free(exam);
    return NULL;
}

void lab_exam_rest(LabExam *examiner) {
    worker_client_stop(&examiner->painters.client);
}

void lab_exam_forget(LabExam *examiner) {
    forget_pictures(examiner);
    painters_destroy(&examiner->painters);
}

void lab_exam_close(LabExam *examiner) {
    lab_exam_forget(examiner);
    rubric_destroy(&examiner->rubric);
}
