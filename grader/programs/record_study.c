// record_study: measures our labs in the scenes of the study, quickly, and records what a kit without
// solutions needs to hold a student's lab against them (points/README.md).
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "base/statistics.h"
#include "exam/exam.h"
#include "exam/handed_out.h"
#include "points/recorded_scene.h"
#include "points/recorded_study.h"
#include "scene/check.h"
#include "study/setting_json.h"
#include "study/study_scene.h"
#include "study/views.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 320, HEIGHT = 240, FRAMES = 5 };

typedef struct RecordStudy {
    char lab[3];
    const char *output;
} RecordStudy;

typedef struct Recorder {
    LabArtist artist;
    StudyView view; // the first one
    const StudyScene *scene;
    char folder[FILES_PATH]; // where the lab's files go
    bool has_truth;
} Recorder;

// Does what the edit replaces stand in the lab as it is handed out? Else it would tell the answer of a task.
static bool stands_handed_out(const Rubric *rubric, const Edit *edit) {
    bool stands = false;
    for (int i = 0; i < rubric->file_count; i++) {
        char *text = strcmp(rubric->files[i], edit->file) == 0 ? handed_out_text(rubric, i) : NULL;
        stands = stands || (text && strstr(text, edit->find));
        free(text);
    }
    check_clear();
    return stands;
}

// What a student's lab can do too: no rays of ours, and no more than a choice that a shader fixes.
static bool is_wanted(const Method *method, const Rubric *rubric) {
    const Change *change = method->change;
    return strcmp(method->lab, rubric->id) == 0 && !method->rays &&
           (!change || (change->edit_count == 1 && stands_handed_out(rubric, &change->edits[0])));
}

static bool time_frames(Recorder *recorder, const Painter *painter, const Setting *setting, double *median) {
    static Reply reply;
    static Image image;
    Setting seen = *setting;
    double times[FRAMES] = {0};
    seen.view = VIEW_PICTURE;
    Request request = truth_view_request(&recorder->view.truth_view, &seen);
    bool ok = true;
    for (int i = -1; ok && i < FRAMES; i++) { // the first one makes the lab's resources
        ok = painters_draw(&recorder->artist.roster, painter, &request, &image, &reply);
        if (i >= 0)
            times[i] = (double)exam_milliseconds(&reply);
    }
    *median = statistics_median(times, FRAMES);
    return ok;
}

static bool write_scene(const Recorder *recorder, const uint8_t *mask) {
    char name[STUDY_FILE];
    const TruthView *seen = &recorder->view.truth_view;
    recorded_study_name(name, recorder->scene->name);
    return recorded_scene_write(recorder->folder, name, &seen->truth.scene, WIDTH, HEIGHT, seen->visibility,
                                mask);
}

static json_t *pack_point(const Method *method, double error, double milliseconds) {
    json_t *knobs = setting_json(&method->setting);
    json_t *point =
        json_pack("{s:s, s:s, s:s, s:o, s:f, s:f}", "family", method->family, "name", method->name, "view",
                  method->setting.view, "knobs", knobs, "error", error, "ms", milliseconds);
    const Edit *edit = method->change ? &method->change->edits[0] : NULL;
    if (edit)
        json_object_set_new(
            point, "edit",
            json_pack("{s:s, s:s, s:s}", "file", edit->file, "find", edit->find, "replace", edit->replace));
    return point;
}

static bool record_method(Recorder *recorder, const Method *method, json_t *points) {
    Measured frame = {0};
    double milliseconds = 0;
    bool ok =
        lab_artist_change(&recorder->artist, method->change) &&
        truth_view_measure(&recorder->view.truth_view, &recorder->artist, &method->setting, true, &frame) &&
        time_frames(recorder, recorder->artist.painter, &method->setting, &milliseconds);
    if (ok && !recorder->has_truth)
        ok = recorder->has_truth = write_scene(recorder, frame.mask);
    if (ok)
        json_array_append_new(points, pack_point(method, frame.metrics.all.mae, milliseconds));
    measured_destroy(&frame);
    return ok;
}

// The lab as it is handed out is what other machines time, too.
static bool time_yardstick(Recorder *recorder, double *milliseconds) {
    const Setting plain = {.view = VIEW_PICTURE, .object = TRUTH_NONE};
    const Painter *skeleton = painters_get(&recorder->artist.roster, (Solved){SOLVED_NONE, NULL}, NULL);
    return skeleton && time_frames(recorder, skeleton, &plain, milliseconds);
}

// Pixels of one object alone are those of all methods of a scene, or the truth's mask would not be one.
static bool record_methods(Recorder *recorder, const MethodList *list, json_t *points) {
    int object = 0;
    bool ok = true;
    for (int i = 0; ok && i < list->count; i++) {
        const Method *method = &list->methods[i];
        if (!is_wanted(method, &recorder->artist.rubric) ||
            (json_array_size(points) > 0 && method->setting.object != object))
            continue;
        object = method->setting.object;
        ok = record_method(recorder, method, points);
    }
    return ok;
}

static bool record_scene(Recorder *recorder, const StudyScene *scene, json_t *scenes) {
    static MethodList list;
    StudyScene still = *scene;
    double yardstick = 0;
    json_t *points = json_array();
    still.moves = false;
    recorder->scene = scene;
    recorder->has_truth = false;
    study_add_methods(&list, scene);
    bool ok = view_create(&recorder->view, &still, 0, (MetricsSize){WIDTH, HEIGHT}, recorder->folder,
                          &recorder->artist) &&
              record_methods(recorder, &list, points) && time_yardstick(recorder, &yardstick);
    view_destroy(&recorder->view);
    if (ok && json_array_size(points) > 0)
        json_array_append_new(scenes, json_pack("{s:s, s:s, s:f, s:O}", "name", scene->name, "title",
                                                scene->title, "yardstick", yardstick, "points", points));
    json_decref(points);
    return ok;
}

static bool concerns(const StudyScene *scene, const Rubric *rubric) {
    static MethodList list;
    study_add_methods(&list, scene);
    for (int i = 0; i < list.count; i++)
        if (is_wanted(&list.methods[i], rubric))
            return true;
    return false;
}

static bool write_study(const Recorder *recorder, json_t *scenes) {
    char path[FILES_PATH];
    recorded_study_index(path, recorder->folder);
    json_t *root = json_pack("{s:i, s:i, s:O}", "width", WIDTH, "height", HEIGHT, "scenes", scenes);
    const bool ok = root && json_dump_file(root, path, JSON_INDENT(1)) == 0;
    json_decref(root);
    return ok || check_fail("%s cannot be written", path);
}

static bool record_lab(const RecordStudy *command) {
    static Recorder recorder;
    char ours[FILES_PATH];
    json_t *scenes = json_array();
    bool ok = places_find_lab(ours, command->lab);
    files_join(recorder.folder, command->output, strrchr(ours, '/') + 1);
    check_append(recorder.folder, sizeof recorder.folder, "/");
    ok = ok && files_make_folder(recorder.folder) &&
         lab_artist_open_measured(&recorder.artist, command->lab, CONTEXT_ANY);
    for (int i = 0; ok && study_scene(i); i++)
        if (concerns(study_scene(i), &recorder.artist.rubric))
            ok = record_scene(&recorder, study_scene(i), scenes);
    if (ok && json_array_size(scenes) > 0)
        ok = write_study(&recorder, scenes);
    lab_artist_close(&recorder.artist);
    json_decref(scenes);
    return ok;
}

static const Option options[] = {{"lab", 0, "NN", "the lab", offsetof(RecordStudy, lab), option_lab}, {0}};

static bool check(void *settings, const Operands *operands) {
    RecordStudy *command = settings;
    command->output = operands->texts[0];
    return command->lab[0] || check_fail("--lab NN is needed");
}

static const CommandLine command_line = {
    .program = "record_study",
    .forms = "--lab NN OUTPUT",
    .about =
        "Records times and errors of a lab's methods in the folder OUTPUT/NN-name, for the students' kit. A\n"
        "lab without methods in the study leaves nothing there.\n",
    .options = options,
    .operand = "OUTPUT",
    .least = 1,
    .most = 1,
    .check = check,
};

int main(int count, char **arguments) {
    static RecordStudy command;
    ContextKind drawing = CONTEXT_ANY; // it stays so: only who asks for EGL gets a GPU's times
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &drawing);
    if (record_lab(&command))
        return 0;
    fprintf(stderr, "record_study: %s\n", check_message());
    return 3;
}
