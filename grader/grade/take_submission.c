// Takes the files of a submission that the rubric names, tells what is passed over, and compiles them.
#include "grade/take_submission.h"

#include "scene/check.h"
#include "base/blame.h"
#include "compile/lab_folder.h"
#include "compile/todo.h"
#include "exam/handed_out.h"
#include "grade/control.h"
#include "grade/found_lab.h"
#include "grade/lab_verdict.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void warn(const char *text, void *result) {
    grade_warn(result, text);
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
    bool ok = found_lab_files(rubric, submission, warn, result);
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
