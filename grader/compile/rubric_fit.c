// Holds views, knobs and their ranges against the lab's table, and tasks and edits against its sources.
#include "compile/rubric_fit.h"

#include "compile/lab_folder.h"
#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

static bool has_view(const Description *lab, const char *view) {
    for (int i = 0; i < lab->stage_count; i++)
        if (strcmp(lab->stages[i], view) == 0)
            return true;
    return strcmp(view, VIEW_PICTURE) == 0 || strcmp(view, VIEW_VISIBILITY) == 0;
}

static bool fit_view(const JsonPlace *place, const char *view, const Description *lab) {
    char known[LAB_MAX_STAGES * (LAB_MAX_NAME + 4)] = "";
    if (has_view(lab, view))
        return true;
    for (int i = 0; i < lab->stage_count; i++)
        check_append(known, sizeof known, ", \"%s\"", lab->stages[i]);
    return json_fields_fail(place, "view", "the lab has no stage \"%s\"; write one of \"%s\", \"%s\"%s", view,
                            VIEW_PICTURE, VIEW_VISIBILITY, known);
}

static bool fit_knob(const JsonPlace *place, const char *name, float value, const Description *lab) {
    char known[LAB_MAX_KNOBS * (LAB_MAX_NAME + 4)] = "";
    for (int i = 0; i < lab->knob_count; i++) {
        const struct KnobText *knob = &lab->knobs[i];
        if (strcmp(knob->name, name) == 0)
            return (value >= knob->low && value <= knob->high) ||
                   json_fields_fail(place, "knobs",
                                    "\"%s\": %g is outside of the knob's range; write a number from %g to %g",
                                    name, (double)value, (double)knob->low, (double)knob->high);
        check_append(known, sizeof known, "%s\"%s\"", i ? ", " : "", knob->name);
    }
    return json_fields_fail(place, "knobs", "the lab has no knob \"%s\"; its knobs are %s", name, known);
}

static bool fit_choices(const JsonPlace *place, const KnobChoice *knob, const Description *lab) {
    for (int i = 0; i < knob->choice_count; i++)
        if (!fit_knob(place, knob->name, knob->choices[i], lab))
            return false;
    return knob->choice_count > 0 ||
           (fit_knob(place, knob->name, knob->low, lab) && fit_knob(place, knob->name, knob->high, lab));
}

bool rubric_fit_lab(const Rubric *rubric, const Description *lab) {
    for (int c = 0; c < rubric->check_count; c++) {
        const Check *check = &rubric->checks[c];
        const JsonPlace place = rubric_check_place(rubric, check);
        if (!fit_view(&place, check->view, lab))
            return false;
        for (int i = 0; i < check->knob_count; i++)
            if (!fit_choices(&place, &check->knobs[i], lab))
                return false;
    }
    return true;
}

typedef struct Marked {
    const Rubric *rubric;
    bool checks[RUBRIC_MAX_CHECKS]; // its task has a block
} Marked;

static void mark(const char *task, void *context) {
    Marked *marked = context;
    for (int c = 0; c < marked->rubric->check_count; c++)
        if (strcmp(marked->rubric->checks[c].task, task) == 0)
            marked->checks[c] = true;
}

static bool fit_tasks(const Rubric *rubric) {
    Marked marked = {.rubric = rubric};
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        files_join(path, rubric->folder, rubric->files[i]);
        char *text = files_read(path, DERIVE_MAX_FILE);
        if (!text)
            return false;
        task_blocks_list(text, mark, &marked);
        free(text);
    }
    for (int c = 0; c < rubric->check_count; c++) {
        const JsonPlace place = rubric_check_place(rubric, &rubric->checks[c]);
        if (!marked.checks[c] && strchr(rubric->checks[c].task, '.'))
            return json_fields_fail(
                &place, "task",
                "no source of the lab has a block \"#ifdef SOLUTION // %s\"; add it, or write "
                "another task",
                rubric->checks[c].task);
    }
    return true;
}

static bool fit_changes(const Rubric *rubric, const Change *changes, int count) {
    for (int i = 0; i < count; i++) {
        const JsonPlace place = rubric_change_place(rubric, &changes[i]);
        if (changes[i].edit_count == 0)
            return json_fields_fail(&place, "edits", "is missing; write a list [ ] of 1 to %d entries",
                                    RUBRIC_MAX_EDITS);
        if (!lab_folder_can_change(rubric, &changes[i]))
            return false;
    }
    return true;
}

bool rubric_fit_sources(const Rubric *rubric) {
    return fit_tasks(rubric) && fit_changes(rubric, rubric->mistakes, rubric->mistake_count) &&
           fit_changes(rubric, rubric->alternatives, rubric->alternative_count);
}
