// Finds the lab, takes the options, and starts the feeds.
#include "window/app.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "intake/submission.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Where the lab's folder with the student's files lies.
static bool find_mine(App *app, const char id[3]) {
    static Submission submission;
    char labs[FILES_PATH];
    places_path(labs, "labs");
    const char *folder = app->options->submission ? app->options->submission : labs;
    char note[400];
    if (submission_open(&submission, NULL, folder) != EXTRACT_OK)
        return false;
    const char *found = submission_find(&submission, id, note, sizeof note);
    snprintf(app->folder, sizeof app->folder, "%s", found ? found : "");
    submission_close(&submission);
    return found || check_fail("there is no lab %s in %s", id, folder);
}

static void note_source(const char *name, void *context) {
    Rubric *rubric = context;
    if (file_watch_is_source(name) && rubric->file_count < RUBRIC_MAX_FILES)
        rubric->files[rubric->file_count++] = strdup(name);
}

// The rubric; where the solutions are not handed out, only the lab's files.
static bool load_rubric(App *app, const char id[3]) {
    char folder[FILES_PATH];
    if (places_find_lab(folder, id))
        return rubric_load(&app->rubric, folder);
    check_clear();
    memcpy(app->rubric.id, id, sizeof app->rubric.id);
    return files_list(app->folder, note_source, &app->rubric);
}

// A copy for students has rubrics, but no solutions.
static bool has_solution(const App *app) {
    char path[FILES_PATH] = "";
    if (app->rubric.json)
        files_join(path, app->rubric.folder, "lab.c");
    return files_exists(path);
}

// The first picture of mine is waited for; what is not looked at yet begins after it.
static void start_feed(App *app, FeedKind kind, void (*wake)(void)) {
    const FeedSetup setup = {{kind, &app->rubric, app->folder, app->options->context, app->options->seconds},
                             kind != FEED_MINE,
                             wake};
    app->waiting[kind] = setup.waits;
    if (kind == FEED_REFERENCE && !has_solution(app))
        recorded_begin(&app->recorded, &app->rubric);
    else if (feed_start(&app->feeds[kind], &setup))
        return;
    snprintf(app->absent[kind], sizeof app->absent[kind], "%s", check_message());
    check_clear();
}

// The state of the first check of the task that the options name. False with a message when there is none.
static bool take_check(App *app) {
    const char *task = app->options->check;
    int c = 0;
    if (!task)
        return true;
    while (c < app->rubric.check_count && strcmp(app->rubric.checks[c].task, task) != 0)
        c++;
    if (c == app->rubric.check_count)
        return check_fail("lab %s has no check of a task \"%s\"", app->rubric.id, task);
    app->state.check = c - 1;
    view_state_step_check(&app->state, &app->rubric, 1);
    return true;
}

static bool take_options(App *app) {
    const AppOptions *options = app->options;
    ViewState *state = &app->state;
    view_state_begin(state, &app->rubric);
    if (!take_check(app))
        return false;
    state->seed = options->seed;
    state->show = options->show;
    state->against_truth = options->against_truth;
    state->text = !options->bare;
    state->volumes = options->volumes;
    state->light_shown = options->light_shown;
    if (options->scene)
        snprintf(state->scene, sizeof state->scene, "%s", options->scene);
    if (options->request.view[0])
        snprintf(state->view, sizeof state->view, "%s", options->request.view);
    for (int i = 0; i < options->request.knob_count; i++)
        view_state_set_knob(state, options->request.knobs[i].name, options->request.knobs[i].value);
    return true;
}

// Who asks at once for a reference that is recorded begins there.
static bool enter_recorded(App *app) {
    if (app->feeds[FEED_REFERENCE].running || !view_state_needs_reference(&app->state))
        return true;
    return app_recorded_enter(app) && app_recorded_fits(app);
}

bool app_create(App *app, const AppOptions *options, void (*wake)(void)) {
    Request request;
    const char *id = options->lab;
    char shaders[FILES_PATH];
    memset(app, 0, sizeof *app);
    app->options = options;
    if (!find_mine(app, id) || !load_rubric(app, id) || !captions_load(&app->captions, &app->rubric))
        return false;
    if (!take_options(app) || !view_state_request(&app->state, 16, 16, &request))
        return false;
    places_path(shaders, "shaders");
    file_watch_begin(&app->watches[0], app->folder, shaders);
    file_watch_begin(&app->watches[1], app->rubric.folder ? app->rubric.folder : "", shaders);
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++)
        start_feed(app, kind, wake);
    app->last = process_now();
    return enter_recorded(app);
}

void app_destroy(App *app) {
    for (int i = 0; i < FEED_COUNT; i++) {
        feed_stop(&app->feeds[i]);
        image_destroy(&app->pictures[i]);
    }
    for (int i = 0; !app->rubric.json && i < app->rubric.file_count; i++)
        free((char *)app->rubric.files[i]);
    image_destroy(&app->composed);
    recorded_end(&app->recorded);
    captions_destroy(&app->captions);
    rubric_destroy(&app->rubric);
}
