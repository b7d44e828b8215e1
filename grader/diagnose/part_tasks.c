// Looks into the annotated source, which has the same lines as ours.
#include "diagnose/part_tasks.h"

#include "base/files.h"
#include "compile/lab_folder.h"

#include <stdlib.h>
#include <string.h>

typedef struct Marks {
    const Rubric *rubric;
    const char *annotated;
    bool *tasks;
    bool given, visited; // lines of no answer are among those that were marked; the last ones were of one
} Marks;

static void mark_task(const char *task, void *context) {
    Marks *marks = context;
    marks->visited = true;
    const int t = rubric_task_index(marks->rubric, task);
    if (t >= 0)
        marks->tasks[t] = true;
}

static void mark_lines(int first, int last, Marks *marks) {
    marks->visited = false;
    task_blocks_between(marks->annotated, first, last, mark_task, marks);
    marks->given = marks->given || !marks->visited;
}

// NULL when it cannot be read.
static char *read_annotated(const Rubric *rubric, const MixedFile *file) {
    char path[FILES_PATH];
    files_join(path, rubric->folder, file->name);
    return files_read(path, DERIVE_MAX_FILE);
}

static int line_of(const char *text, size_t at) {
    int line = 1;
    for (size_t i = 0; i < at; i++)
        line += text[i] == '\n';
    return line;
}

void part_tasks_mark(bool tasks[], const Rubric *rubric, const MixedFile *file, size_t begin, size_t end) {
    char *annotated = read_annotated(rubric, file);
    Marks marks = {rubric, annotated, tasks, false, false};
    if (annotated)
        mark_lines(line_of(file->ours_text, begin), line_of(file->ours_text, end), &marks);
    free(annotated);
}

void part_tasks_mark_outside(bool tasks[], const Rubric *rubric, const MixedFile *file) {
    const Functions *ours = &file->ours;
    size_t from = 0;
    for (int i = 0; i <= ours->count; i++) {
        const size_t end = i < ours->count ? ours->list[i].begin : strlen(ours->text);
        if (strspn(ours->text + from, " \n") < end - from)
            part_tasks_mark(tasks, rubric, file, from, end);
        from = i < ours->count ? ours->list[i].end : end;
    }
}

bool part_tasks_narrow(bool tasks[], const Rubric *rubric, const MixedFile *file, const Hunks *hunks) {
    char *annotated = read_annotated(rubric, file);
    bool changed[EXAM_MAX_TASKS] = {0}, any = false;
    Marks marks = {rubric, annotated, changed, false, false};
    for (int i = 0; annotated && i < hunks->count && !hunks->unknown; i++)
        mark_lines(hunks->list[i].first_line, hunks->list[i].last_line, &marks);
    free(annotated);
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        any = any || (tasks[t] && changed[t]);
    for (int t = 0; any && t < EXAM_MAX_TASKS; t++)
        tasks[t] = tasks[t] && changed[t];
    return marks.given || !any;
}
