// record_arena: draws the hidden cameras of a lab's contest from a seed, traces what each sees, and records
// it with the settings in which a lab is tried (compete/README.md).
#include "base/command_line.h"
#include "base/option_values.h"
#include "compete/arena.h"
#include "points/recorded_scene.h"
#include "scene/check.h"
#include "study/setting_json.h"
#include "study/study_scene.h"
#include "study/views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct RecordArena {
    char lab[3];
    uint64_t seed;
    const char *output;
} RecordArena;

static const MetricsSize size = {ARENA_WIDTH, ARENA_HEIGHT};

// Which pixels count is said by a frame of ours.
static bool record_camera(const RecordArena *command, const StudyScene *scene, const Setting *setting,
                          LabArtist *artist, Random *random, int camera) {
    static Scene made;
    char name[ARENA_TEXT];
    StudyView view;
    Measured frame = {0};
    views_make_drawn(scene, random, &made);
    const bool ok = view_create_of(&view, scene, &made, size, command->output, artist) &&
                    truth_view_measure(&view.truth_view, artist, setting, true, &frame);
    arena_camera(name, camera);
    const bool written = ok && recorded_scene_write(command->output, name, &made, size.width, size.height,
                                                    view.truth_view.visibility, frame.mask);
    measured_destroy(&frame);
    view_destroy(&view);
    return written;
}

static bool write_index(const RecordArena *command, const StudyContest *contest, json_t *settings) {
    char path[FILES_PATH];
    json_t *root = json_pack("{s:s, s:o, s:s, s:f, s:O}", "lab", contest->lab, "seed",
                             json_sprintf("%llu", (unsigned long long)command->seed), "scene", contest->scene,
                             "most error", contest->most_error, "settings", settings);
    arena_index(path, command->output);
    const bool ok = root && json_dump_file(root, path, JSON_INDENT(1)) == 0;
    json_decref(root);
    return ok || check_fail("%s cannot be written", path);
}

// The settings of the lab in the study's scene; the first of them in `first`.
static json_t *settings_of(const StudyContest *contest, const StudyScene *scene, Setting *first) {
    static MethodList list;
    json_t *settings = json_array();
    study_add_methods(&list, scene);
    for (int i = 0; i < list.count; i++) {
        const Method *method = &list.methods[i];
        if (strcmp(method->lab, contest->lab) != 0 || method->change)
            continue;
        if (json_array_size(settings) == 0)
            *first = method->setting;
        json_array_append_new(settings,
                              json_pack("{s:s, s:s, s:o}", "name", method->name, "view", method->setting.view,
                                        "knobs", setting_json(&method->setting)));
    }
    INVARIANT(json_array_size(settings) > 0 && json_array_size(settings) <= ARENA_SETTINGS);
    return settings;
}

static bool record(const RecordArena *command) {
    LabArtist artist = {0};
    Setting first = {0};
    Random random = {command->seed};
    char folder[FILES_PATH];
    const StudyContest *contest = study_contest(command->lab);
    if (!contest)
        return false;
    INVARIANT(study_scene_named(contest->scene));
    StudyScene scene = *study_scene_named(contest->scene);
    scene.moves = false;
    scene.query.samples /= 4; // the mean of a picture is known well enough
    json_t *settings = settings_of(contest, &scene, &first);
    snprintf(folder, sizeof folder, "%s/truth/", command->output);
    bool ok = files_make_folder(folder) && lab_artist_open(&artist, command->lab);
    for (int i = 0; ok && i < ARENA_CAMERAS; i++)
        ok = record_camera(command, &scene, &first, &artist, &random, i);
    ok = ok && write_index(command, contest, settings);
    lab_artist_close(&artist);
    json_decref(settings);
    return ok;
}

static const Option options[] = {{"lab", 0, "NN", "the lab", offsetof(RecordArena, lab), option_lab},
                                 {"seed", 0, "N", "of the cameras (default 1, which everybody knows)",
                                  offsetof(RecordArena, seed), option_seed},
                                 {0}};

static bool check(void *settings, const Operands *operands) {
    RecordArena *command = settings;
    command->output = operands->texts[0];
    return command->lab[0] || check_fail("--lab NN is needed");
}

static const CommandLine command_line = {
    .program = "record_arena",
    .forms = "--lab NN [--seed N] OUTPUT",
    .about = "Records the cameras of a lab's contest and what is right there in the folder OUTPUT, for "
             "build/compete.\n",
    .options = options,
    .ending = "exit status: 0; 2 usage; 3 the lab has no contest, or it could not be recorded\n",
    .operand = "OUTPUT",
    .least = 1,
    .most = 1,
    .check = check,
};

int main(int count, char **arguments) {
    static RecordArena command = {.seed = 1};
    ContextKind drawing = CONTEXT_ANY;
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &drawing);
    if (record(&command))
        return 0;
    fprintf(stderr, "record_arena: %s\n", check_message());
    return 3;
}
