// Reads study.json and the files of its scenes, which record_study has written.
#include "points/recorded_study.h"

#include "points/recorded_scene.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

void recorded_study_name(char name[STUDY_FILE], const char *scene) {
    snprintf(name, STUDY_FILE, "study-%.*s", STUDY_NAME, scene);
}

void recorded_study_index(char path[FILES_PATH], const char *folder) {
    files_join(path, folder, "study.json");
}

bool recorded_study_knobs(KnobSetting knobs[LAB_MAX_KNOBS], int *count, json_t *object) {
    const char *name;
    json_t *value;
    json_object_foreach(object, name, value) {
        if (*count == LAB_MAX_KNOBS || !json_is_number(value))
            return false;
        KnobSetting *knob = &knobs[(*count)++];
        snprintf(knob->name, sizeof knob->name, "%s", name);
        knob->value = (float)json_number_value(value);
    }
    return true;
}

static bool take_point(RecordedPoint *point, json_t *entry) {
    json_t *knobs, *edit = NULL;
    return json_unpack(entry, "{s:s, s:s, s:s, s:o, s?o, s:F, s:F}", "family", &point->family, "name",
                       &point->name, "view", &point->view, "knobs", &knobs, "edit", &edit, "error",
                       &point->error, "ms", &point->milliseconds) == 0 &&
           recorded_study_knobs(point->knobs, &point->knob_count, knobs) &&
           (!edit || json_unpack(edit, "{s:s, s:s, s:s}", "file", &point->edit.file, "find",
                                 &point->edit.find, "replace", &point->edit.replace) == 0);
}

static bool take_scene(RecordedScene *scene, json_t *entry) {
    json_t *points, *point;
    size_t i;
    if (json_unpack(entry, "{s:s, s:s, s:F, s:o}", "name", &scene->name, "title", &scene->title, "yardstick",
                    &scene->yardstick, "points", &points) != 0)
        return false;
    json_array_foreach(points, i,
                       point) if (scene->point_count == STUDY_MOST_POINTS ||
                                  !take_point(&scene->points[scene->point_count++], point)) return false;
    return scene->point_count > 0 && strlen(scene->name) < STUDY_NAME && scene->yardstick > 0;
}

static bool take_all(RecordedStudy *study) {
    json_t *scenes, *scene;
    size_t i;
    if (json_unpack(study->json, "{s:i, s:i, s:o}", "width", &study->width, "height", &study->height,
                    "scenes", &scenes) != 0)
        return false;
    json_array_foreach(scenes, i,
                       scene) if (study->scene_count == STUDY_MOST_SCENES ||
                                  !take_scene(&study->scenes[study->scene_count++], scene)) return false;
    return study->width > 0 && study->height > 0 && study->width <= PROTOCOL_MAX_SIZE &&
           study->height <= PROTOCOL_MAX_SIZE;
}

bool recorded_study_load(RecordedStudy *study, const Rubric *rubric) {
    char path[FILES_PATH];
    memset(study, 0, sizeof *study);
    study->folder = rubric->folder;
    recorded_study_index(path, rubric->folder);
    if (!files_exists(path))
        return check_fail(
            "no points of lab %s are recorded here: not every lab is in the study, and not every "
            "kit has it; ask your course",
            rubric->id);
    study->json = json_load_file(path, 0, NULL);
    if (study->json && take_all(study))
        return true;
    recorded_study_destroy(study);
    return check_fail("%s is not whole: unpack the kit again", path);
}

void recorded_study_destroy(RecordedStudy *study) {
    json_decref(study->json);
    memset(study, 0, sizeof *study);
}

bool recorded_study_scene(const RecordedStudy *study, int i, Scene *scene, Image *truth) {
    char name[STUDY_FILE];
    recorded_study_name(name, study->scenes[i].name);
    return recorded_scene_read(study->folder, name, scene, study->width, study->height, truth);
}
