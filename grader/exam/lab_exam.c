#include "exam/lab_exam.h"

#include "scene/check.h"
#include "base/places.h"
#include "exam/exam_file.h"

#include <stdlib.h>

bool examiner_open(Examiner *examiner, const char *id) {
    char folder[FILES_PATH];
    *examiner = (Examiner){0};
    return (home_find_lab(folder, id) || check_fail("there is no lab \"%s\"", id)) &&
           rubric_load(&examiner->rubric, folder);
}

Exam *examiner_exam(Examiner *examiner, const GradeOptions *options) {
    if (examiner->exam)
        return examiner->exam;
    examiner->roster.rubric = &examiner->rubric;
    examiner->roster.context = options->context;
    Exam *exam = calloc(1, sizeof *exam);
    INVARIANT(exam);
    if (recorded_only() ? recorded_load(exam, &examiner->rubric, options->seed)
                        : exam_create(exam, &examiner->rubric, &examiner->roster, options->seed))
        return examiner->exam = exam;
    free(exam);
    return NULL;
}

void examiner_rest(Examiner *examiner) {
    client_stop(&examiner->roster.client);
}

void examiner_forget(Examiner *examiner) {
    if (examiner->exam)
        exam_destroy(examiner->exam);
    free(examiner->exam);
    examiner->exam = NULL;
    roster_destroy(&examiner->roster);
}

void examiner_close(Examiner *examiner) {
    examiner_forget(examiner);
    rubric_destroy(&examiner->rubric);
}
