// A small state machine over the lines of a source: which half of which task a line stands in, and whether it
// is kept.
#include "compile/task_blocks.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char MARKER[] = "#ifdef SOLUTION";

typedef enum LineKind { LINE_TEXT, LINE_BEGIN, LINE_IF, LINE_ELSE, LINE_END } LineKind;

static LineKind line_kind(const char *line) {
    if (strncmp(line, MARKER, sizeof MARKER - 1) == 0)
        return LINE_BEGIN;
    if (strncmp(line, "#if", 3) == 0)
        return LINE_IF;
    if (strncmp(line, "#else", 5) == 0)
        return LINE_ELSE;
    return strncmp(line, "#endif", 6) == 0 ? LINE_END : LINE_TEXT;
}

// The id in "#ifdef SOLUTION // 3.1".
static bool read_task(const char *line, char task[16]) {
    return sscanf(line + sizeof MARKER - 1, " // %15[0-9.]", task) == 1;
}

// 10 of "3.10".
static int task_number(const char *task) {
    const char *dot = strchr(task, '.');
    return dot ? atoi(dot + 1) : 0;
}

// Is the task in the list "3.4 3.6"?
static bool is_listed(const char *list, const char *task) {
    const size_t length = strlen(task);
    for (const char *at = strstr(list, task); at; at = strstr(at + 1, task))
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static bool is_solved(Solved solved, const char *task) {
    switch (solved.which) {
    case SOLVED_ALL:
        return true;
    case SOLVED_NONE:
        return false;
    case SOLVED_UP_TO:
        return task_number(task) <= task_number(solved.task);
    case SOLVED_ALL_BUT:
        return strcmp(task, solved.task) != 0 && strchr(solved.task, '.') != NULL;
    case SOLVED_WITHOUT:
        return !is_listed(solved.task, task);
    }
    return false;
}

typedef struct Selection {
    bool inside, in_else; // of a marked block
    bool take_first;      // the answer's half
    int nested;           // other #ifs inside the block
    int begun;            // line of its #ifdef
} Selection;

// Follows the markers. Sets *keep to whether this line belongs to the result.
static bool step(Selection *at, const char *name, int number, const char *line, Solved solved, bool *keep) {
    LineKind kind = line_kind(line);
    char task[16];
    *keep = !at->inside || at->take_first == !at->in_else;
    if (kind == LINE_BEGIN) {
        if (at->inside)
            return check_fail("%s:%d: a SOLUTION block inside the one of line %d", name, number, at->begun);
        if (!read_task(line, task))
            return check_fail("%s:%d: expected a task id: #ifdef SOLUTION // 3.1", name, number);
        *at = (Selection){.inside = true, .take_first = is_solved(solved, task), .begun = number};
        *keep = false;
    } else if (at->inside && kind == LINE_IF) {
        at->nested++;
    } else if (at->inside && kind == LINE_ELSE && at->nested == 0) {
        at->in_else = true;
        *keep = false;
    } else if (at->inside && kind == LINE_END && at->nested-- == 0) {
        *at = (Selection){0};
        *keep = false;
    }
    return true;
}

char *task_blocks_select(const char *name, const char *text, Solved solved, bool keep_lines) {
    Selection at = {0};
    char *result = malloc(strlen(text) + 1), *end = result;
    int number = 1;
    for (const char *line = text; result && *line; number++) {
        size_t length = strcspn(line, "\n");
        length += line[length] == '\n';
        bool keep;
        if (!step(&at, name, number, line, solved, &keep)) {
            free(result);
            return NULL;
        }
        if (keep)
            memcpy(end, line, length), end += length;
        else if (keep_lines)
            *end++ = '\n';
        line += length;
    }
    if (result && at.inside) {
        check_fail("%s:%d: this SOLUTION block has no #endif", name, at.begun);
        free(result);
        return NULL;
    }
    if (result)
        *end = '\0';
    return result;
}

char *task_blocks_edit(const char *text, const Edit *edit) {
    const char *at = strstr(text, edit->find);
    if (!at || strstr(at + 1, edit->find)) {
        check_fail("the text to replace stands in %s %s; copy a longer piece from there: %.200s", edit->file,
                   at ? "more than once" : "nowhere", edit->find);
        return NULL;
    }
    size_t before = (size_t)(at - text), found = strlen(edit->find), added = strlen(edit->replace);
    char *result = malloc(strlen(text) - found + added + 1);
    if (!result)
        return NULL;
    memcpy(result, text, before);
    memcpy(result + before, edit->replace, added);
    strcpy(result + before + added, at + found);
    return result;
}

void task_blocks_list(const char *text, void (*visit)(const char *task, void *context), void *context) {
    char task[16];
    for (const char *line = text; line && *line; line = strchr(line, '\n'), line += line != NULL)
        if (line_kind(line) == LINE_BEGIN && read_task(line, task))
            visit(task, context);
}

// The line on which the answer of the block that begins on `line`, number `at`, ends.
static int answer_end(const char *line, int at) {
    for (int nested = 0; line && *line; at++) {
        line = strchr(line, '\n');
        line += line != NULL;
        LineKind kind = line ? line_kind(line) : LINE_END;
        nested += kind == LINE_IF;
        if (nested == 0 && (kind == LINE_ELSE || kind == LINE_END))
            return at;
        nested -= kind == LINE_END;
    }
    return at;
}

void task_blocks_between(const char *text, int first, int last,
                         void (*visit)(const char *task, void *context), void *context) {
    char task[16];
    int at = 1;
    for (const char *line = text; line && *line; line = strchr(line, '\n'), line += line != NULL, at++)
        if (line_kind(line) == LINE_BEGIN && read_task(line, task) && at < last &&
            answer_end(line, at) >= first)
            visit(task, context);
}
