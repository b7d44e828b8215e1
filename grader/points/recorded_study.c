// Reads study.json and the files of its scenes, which record_study has written.
#include "points/recorded_study.h"

#include "base/files.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

void recorded_study_place(char path[FILES_PATH], const char *folder, const char *scene, const char *end) {
    char name[STUDY_NAME + 32];
    snprintf(name, sizeof name, "study-%s.%s", scene, end);
    files_join(path, folder, name);
}

void recorded_study_index(char path[FILES_PATH], const char *folder) {
    files_join(path, folder, "study.json");
}

static bool take_knobs(RecordedPoint *point, json_t *knobs) {
    const char *name;
    json_t *value;
    json_object_foreach(knobs, name, value) {
        if (point->knob_count == LAB_MAX_KNOBS || !json_is_number(value))
            return false;
        KnobSetting *knob = &point->knobs[point->knob_count++];
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
           take_knobs(point, knobs) &&
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

static bool read_scene(Scene *scene, const char *path) {
    FILE *file = fopen(path, "rb");
    const bool ok = file && fread(scene, sizeof *scene, 1, file) == 1 && fgetc(file) == EOF &&
                    scene->object_count >= 0 && scene->object_count <= SCENE_MAX_OBJECTS &&
                    scene->light_count >= 0 && scene->light_count <= SCENE_MAX_LIGHTS;
    if (file)
        fclose(file);
    return ok || check_fail("%s is no scene of this version: unpack the kit again", path);
}

bool recorded_study_scene(const RecordedStudy *study, int i, Scene *scene, Image *truth) {
    char path[FILES_PATH];
    recorded_study_place(path, study->folder, study->scenes[i].name, "scene");
    if (!read_scene(scene, path) || !scene_check(scene))
        return false;
    recorded_study_place(path, study->folder, study->scenes[i].name, "png");
    image_destroy(truth);
    return image_read_png(truth, path) &&
           ((truth->width == study->width && truth->height == study->height) ||
            check_fail("%s has another size than study.json says: unpack the kit again", path));
}
