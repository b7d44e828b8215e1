// The parts of a rubric, where each stands for messages, and what must be freed.
#include "compile/rubric.h"

#include "scene/check.h"
#include "scene/count.h"

#include <stdlib.h>
#include <string.h>

void rubric_destroy(Rubric *rubric) {
    json_decref(rubric->json);
    for (int i = 0; i < rubric->hint_count; i++)
        free(rubric->hints[i].texts);
    free(rubric->hints);
    free(rubric->mistakes);
    free(rubric->alternatives);
    free((char *)rubric->folder);
    *rubric = (Rubric){0};
}

JsonPlace rubric_check_place(const Rubric *rubric, const Check *check) {
    const JsonPlace file = {.folder = rubric->folder, .file = "rubric.json"};
    return json_fields_enter(&file, "checks", (size_t)(check - rubric->checks), check->name);
}

JsonPlace rubric_change_place(const Rubric *rubric, const Change *change) {
    const struct {
        const Change *changes;
        int count;
        const char *file;
    } lists[] = {{rubric->mistakes, rubric->mistake_count, "mistakes.json"},
                 {rubric->alternatives, rubric->alternative_count, "alternatives.json"}};
    for (size_t l = 0; l < COUNT(lists); l++)
        for (int i = 0; i < lists[l].count; i++)
            if (change == &lists[l].changes[i])
                return json_fields_enter(&(JsonPlace){.folder = rubric->folder, .file = lists[l].file}, "",
                                         (size_t)i, change->name);
    JsonPlace place = {.folder = rubric->folder, .file = "a change of it"};
    check_append(place.entry, sizeof place.entry, "\"%s\": ", change->name);
    return place;
}

bool rubric_uses_scene(const Check *check, const char *scene) {
    for (int i = 0; i < check->scene_count; i++)
        if (strcmp(check->scenes[i], scene) == 0)
            return true;
    return false;
}

int rubric_check_points(const Rubric *rubric) {
    int points = 0;
    for (int i = 0; i < rubric->check_count; i++)
        points += rubric->checks[i].points;
    return points;
}

int rubric_points(const Rubric *rubric) {
    int points = rubric_check_points(rubric);
    for (int i = 0; i < rubric->prediction_count; i++)
        points += rubric->prediction_points[i];
    return points;
}

const char *rubric_task(const Rubric *rubric, int n) {
    for (int c = 0; c < rubric->check_count; c++) {
        const char *dot = strchr(rubric->checks[c].task, '.');
        if (dot && atoi(dot + 1) == n)
            return rubric->checks[c].task;
    }
    return NULL;
}

int rubric_task_index(const Rubric *rubric, const char *task) {
    for (int i = 0; i < rubric->hint_count; i++)
        if (strcmp(rubric->hints[i].task, task) == 0)
            return i;
    return -1;
}

static const Change *find_change(const Rubric *rubric, const Change *changes, int count, const char *kind,
                                 const char *name) {
    for (int i = 0; i < count; i++)
        if (strcmp(changes[i].name, name) == 0)
            return &changes[i];
    check_fail("lab %s has no %s \"%s\" in %ss.json", rubric->id, kind, name, kind);
    return NULL;
}

const Change *rubric_mistake(const Rubric *rubric, const char *name) {
    return find_change(rubric, rubric->mistakes, rubric->mistake_count, "mistake", name);
}

const Change *rubric_alternative(const Rubric *rubric, const char *name) {
    return find_change(rubric, rubric->alternatives, rubric->alternative_count, "alternative", name);
}

const char *rubric_hint(const Rubric *rubric, const char *task, int n) {
    for (int i = 0; i < rubric->hint_count; i++)
        if (strcmp(rubric->hints[i].task, task) == 0)
            return n < rubric->hints[i].count ? rubric->hints[i].texts[n] : NULL;
    return NULL;
}
