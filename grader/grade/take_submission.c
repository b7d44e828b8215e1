// Takes the files of a submission that the rubric names, tells what is passed over, and compiles them.
#include "grade/take_submission.h"

#include "scene/check.h"
#include "base/blame.h"
#include "base/find_file.h"
#include "compile/lab_folder.h"
#include "compile/todo.h"
#include "exam/handed_out.h"
#include "grade/control.h"
#include "grade/lab_verdict.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

typedef struct Ignored {
    const Rubric *rubric;
    char taken[RUBRIC_MAX_FILES][FIND_FILE_NAME]; // under which name each file of the rubric lies there
    char predictions[FIND_FILE_NAME];             // and what was predicted
    LabResult *result;
    int count;
} Ignored;

static void find_files(Ignored *ignored, const char *folder) {
    for (int i = 0; i < ignored->rubric->file_count; i++)
        if (!find_file(ignored->taken[i], folder, ignored->rubric->files[i]))
            ignored->taken[i][0] = '\0';
    if (!find_file(ignored->predictions, folder, PREDICTION_FILE))
        ignored->predictions[0] = '\0';
}

// Is it taken for a file of the lab? Then, under another name, that is said.
static bool is_taken(const Ignored *ignored, const char *name) {
    char text[600];
    for (int i = 0; i < ignored->rubric->file_count; i++) {
        const char *wanted = ignored->rubric->files[i];
        if (strcmp(ignored->taken[i], name) != 0)
            continue;
        snprintf(text, sizeof text, "%.255s is taken for %.255s", name, wanted);
        if (strcmp(wanted, name) != 0)
            grade_warn(ignored->result, text);
        return true;
    }
    return false;
}

static void note_ignored(const char *name, void *context) {
    Ignored *ignored = context;
    if (is_taken(ignored, name) || name[0] == '.' || strcmp(name, ignored->predictions) == 0)
        return;
    if (handed_out_has(ignored->rubric, name) || ++ignored->count > 8)
        return;
    char text[400];
    snprintf(text, sizeof text, "ignored: %.300s (not a file of this lab)", name);
    grade_warn(ignored->result, text);
}

// Who has begun an optional task is judged by it, even where the picture is still that of the skeleton.
static void note_begun(LabResult *result, const Rubric *rubric, const char *folder) {
    char place[FILES_PATH];
    for (int c = 0; c < result->check_count; c++)
        result->checks[c].begun = !todo_find(rubric, folder, rubric->checks[c].task, place, sizeof place);
}

// What fails although ours is compiled in the same way is tried once more: room or a process may have been
// missing for a moment. False with a message when ours fails, too.
static bool compile(bool *ok, WorkerClient *student, const Rubric *rubric, const char *submission,
                    char log[COMPILE_LOG]) {
    *ok = lab_folder_submission(student->folder, rubric, submission, student->jail, log);
    if (*ok || handed_out_alone())
        return true;
    check_clear();
    if (!control_compiles(rubric, student->jail))
        return false;
    files_empty(student->folder);
    *ok = lab_folder_submission(student->folder, rubric, submission, student->jail, log);
    return true;
}

bool take_submission(LabResult *result, WorkerClient *student, const Rubric *rubric, const char *submission) {
    static char log[COMPILE_LOG], text[COMPILE_LOG + 4096];
    check_clear();
    Ignored ignored = {.rubric = rubric, .result = result};
    find_files(&ignored, submission);
    check_clear();
    bool ok = files_check_folder(submission) && files_list(submission, note_ignored, &ignored);
    if (!ok && blame_is_ours(errno))
        return false;
    if (ok && !compile(&ok, student, rubric, submission, log))
        return false;
    if (!ok) {
        snprintf(text, sizeof text, "%s%s%s", check_message(), log[0] ? ":\n" : "", log);
        grade_refuse(result, text);
    } else if (log[0]) {
        grade_warn(result, log);
    }
    check_clear();
    if (ok)
        note_begun(result, rubric, submission);
    return true;
}
