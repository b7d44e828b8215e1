#include "proof/lab_changes.h"

#include "proof/mutations.h"

#include <stdio.h>

static void list_changes(LabChanges *changes) {
    const Rubric *rubric = &changes->examiner.rubric;
    for (int i = 0; i < rubric->file_count; i++) {
        Source source;
        source_read(&source, rubric->files[i], changes->court.texts[i]);
        changes->mutants.file = i;
        mutations_list(&changes->mutants, &source);
        source_destroy(&source);
    }
}

bool lab_changes_open(LabChanges *changes, const char *id) {
    *changes = (LabChanges){0};
    if (!lab_exam_open(&changes->examiner, id) || !court_open(&changes->court, &changes->examiner.rubric))
        return false;
    list_changes(changes);
    return true;
}

void lab_changes_close(LabChanges *changes) {
    mutants_destroy(&changes->mutants);
    court_close(&changes->court);
    lab_exam_close(&changes->examiner);
}

void lab_changes_describe(char text[CHANGE_TEXT], const LabChanges *changes, int i) {
    const Mutant *mutant = &changes->mutants.list[i];
    char place[32] = "";
    if (mutant->nth > 1)
        snprintf(place, sizeof place, " (place %d)", mutant->nth);
    snprintf(text, CHANGE_TEXT, "%s %s:%d (%s): %.400s%s -> %.400s", changes->examiner.rubric.id,
             changes->examiner.rubric.files[mutant->file], mutant->line, mutant->task, mutant->before, place,
             mutant->replacement[0] ? mutant->replacement : "nothing");
}
