#include "grade/record_report.h"

#include "grade/progress.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

static bool record_lab(Progress *progress, const LabResult *lab, const Session *session) {
    MistakesMet met = {0};
    for (int i = 0; i < session->lab_count; i++)
        for (int c = 0; c < lab->check_count && strcmp(session->examiners[i].rubric.id, lab->id) == 0; c++)
            if (lab->checks[c].has_cause && !lab->checks[c].undone)
                mistakes_met_add(&met, &session->examiners[i].rubric, lab->checks[c].mistake);
    return progress_record(progress, lab->id, lab->score, lab->max_score, result_done(lab), &met);
}

void record_report(const Report *report, const Session *session, bool told) {
    static Progress progress;
    for (int i = 0; i < report->lab_count; i++) {
        const LabResult *lab = &report->labs[i];
        check_clear();
        if (lab->status <= LAB_FAILED && !record_lab(&progress, lab, session))
            fprintf(stderr, "grade: %s\n", check_message());
        if (told && result_done(lab))
            printf("Lab %s is done. The answers to its questions, and what to try: make answer LAB=%s\n",
                   lab->id, lab->id);
    }
    if (progress.note[0])
        fprintf(stderr, "grade: %s\n", progress.note);
}
