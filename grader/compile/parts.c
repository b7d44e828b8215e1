#include "compile/parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add(Parts *parts, LabPart part) {
    if (parts->count < EXAM_MAX_PARTS)
        parts->list[parts->count++] = part;
}

// The function that this place of the text lies in; "": none.
static const char *function_at(const Functions *handed, size_t place) {
    for (int k = 0; k < handed->count; k++)
        if (place >= handed->list[k].begin && place < handed->list[k].end)
            return handed->list[k].name;
    return "";
}

// Functions that are to be written, and are not there yet, are no parts of what was handed out.
static bool has_task_outside(const Functions *handed) {
    for (const char *at = strstr(handed->text, "TODO("); at; at = strstr(at + 1, "TODO("))
        if (!function_at(handed, (size_t)(at - handed->text))[0])
            return true;
    return false;
}

void parts_list(Parts *parts, const Rubric *rubric, char *const texts[]) {
    *parts = (Parts){.rubric = rubric};
    for (int i = 0; i < rubric->file_count; i++) {
        Functions *handed = &parts->handed[i];
        parts->texts[i] = texts[i];
        functions_split(handed, texts[i]);
        for (int k = 0; k < handed->count && !handed->whole; k++)
            if (functions_find(handed, handed->list[k].name) == &handed->list[k])
                add(parts, (LabPart){.file = i, .function = handed->list[k].name});
        add(parts, (LabPart){.file = i, .function = "", .whole = handed->whole || has_task_outside(handed)});
    }
}

void parts_destroy(Parts *parts) {
    for (int i = 0; i < RUBRIC_MAX_FILES; i++)
        free(parts->texts[i]);
    *parts = (Parts){0};
}

bool parts_have_task(const Parts *parts, int p, const char *task) {
    const LabPart *part = &parts->list[p];
    const Functions *handed = &parts->handed[part->file];
    char mark[32];
    snprintf(mark, sizeof mark, "TODO(%s)", task);
    for (const char *at = strstr(handed->text, mark); at; at = strstr(at + 1, mark))
        if (part->whole || strcmp(function_at(handed, (size_t)(at - handed->text)), part->function) == 0)
            return true;
    return false;
}

bool parts_same(const Parts *parts, int p, const Functions *version) {
    const LabPart *part = &parts->list[p];
    const Functions *handed = &parts->handed[part->file];
    if (part->whole)
        return strcmp(version->text, handed->text) == 0;
    return part->function[0] ? functions_same(version, handed, part->function)
                             : functions_same_outside(version, handed);
}

bool parts_exist(const Parts *parts, int p, const Functions *version) {
    const char *name = parts->list[p].function;
    return parts->list[p].whole || (!version->whole && (!name[0] || functions_find(version, name)));
}

char *parts_reset(const Parts *parts, int file, const Functions *version, int p, int q) {
    Choice choice = {0};
    for (int i = 0; i < 2; i++) {
        const int number = i == 0 ? p : q;
        const LabPart *part = number >= 0 ? &parts->list[number] : NULL;
        if (!part || part->file != file)
            continue;
        if (part->whole)
            return strdup(parts->texts[file]);
        if (part->function[0])
            choice.names[choice.count++] = part->function;
        else
            choice.outside = true;
    }
    return functions_compose(version, &parts->handed[file], &choice);
}
