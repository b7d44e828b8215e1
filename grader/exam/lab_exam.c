#include "exam/lab_exam.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "exam/exam_file.h"
#include "exam/handed_out.h"

#include <stdlib.h>

bool lab_exam_open(LabExam *examiner, const char *id) {
    char folder[FILES_PATH];
    *examiner = (LabExam){0};
    return (places_find_lab(folder, id) || check_fail("there is no lab \"%s\"", id)) &&
           rubric_load(&examiner->rubric, folder);
}

Exam *lab_exam_exam(LabExam *examiner, const GradeOptions *options) {
    if (examiner->exam)
        return examiner->exam;
    examiner->painters.rubric = &examiner->rubric;
    examiner->painters.context = options->context;
    Exam *exam = calloc(1, sizeof *exam);
    INVARIANT(exam);
    if (handed_out_alone() ? exam_file_load(exam, &examiner->rubric, options->seed)
                           : exam_create(exam, &examiner->rubric, &examiner->painters, options->seed))
        return examiner->exam = exam;
    free(exam);
    return NULL;
}

void lab_exam_rest(LabExam *examiner) {
    worker_client_stop(&examiner->painters.client);
}

void lab_exam_forget(LabExam *examiner) {
    if (examiner->exam)
        exam_destroy(examiner->exam);
    free(examiner->exam);
    examiner->exam = NULL;
    painters_destroy(&examiner->painters);
}

void lab_exam_close(LabExam *examiner) {
    lab_exam_forget(examiner);
    rubric_destroy(&examiner->rubric);
}
