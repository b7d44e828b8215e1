// Starts the feeds, and at each tick: looks at saved files and new pictures, asks for what is missing, and
// composes.
#include "window/app.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "intake/submission.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double LOOK_EVERY = 0.05, NOTICE_FOR = 4, LONGEST_STEP = 0.5; // seconds

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

static void start_feed(App *app, FeedKind kind, void (*wake)(void)) {
    const FeedSetup setup = {{kind, &app->rubric, app->folder, app->options->context, app->options->seconds},
                             wake};
    if (kind == FEED_REFERENCE && !has_solution(app))
        check_fail("no reference here: the solutions are not handed out");
    else if (feed_start(&app->feeds[kind], &setup))
        return;
    snprintf(app->absent[kind], sizeof app->absent[kind], "%s", check_message());
    check_clear();
}

static void take_options(App *app) {
    const AppOptions *options = app->options;
    ViewState *state = &app->state;
    view_state_begin(state, &app->rubric);
    state->seed = options->seed;
    state->show = options->show;
    state->against_truth = options->against_truth;
    state->text = !options->bare;
    if (options->scene)
        snprintf(state->scene, sizeof state->scene, "%s", options->scene);
    if (options->request.view[0])
        snprintf(state->view, sizeof state->view, "%s", options->request.view);
    for (int i = 0; i < options->request.knob_count; i++)
        view_state_set_knob(state, options->request.knobs[i].name, options->request.knobs[i].value);
}

bool app_create(App *app, const AppOptions *options, void (*wake)(void)) {
    Request request;
    const char *id = options->lab;
    char shaders[FILES_PATH];
    memset(app, 0, sizeof *app);
    app->options = options;
    if (!find_mine(app, id) || !load_rubric(app, id))
        return false;
    take_options(app);
    if (!view_state_request(&app->state, 16, 16, &request))
        return false;
    places_path(shaders, "shaders");
    file_watch_begin(&app->watches[0], app->folder, shaders);
    file_watch_begin(&app->watches[1], app->rubric.folder ? app->rubric.folder : "", shaders);
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++)
        start_feed(app, kind, wake);
    app->last = process_now();
    return true;
}

void app_destroy(App *app) {
    for (int i = 0; i < FEED_COUNT; i++) {
        feed_stop(&app->feeds[i]);
        image_destroy(&app->pictures[i]);
    }
    for (int i = 0; !app->rubric.json && i < app->rubric.file_count; i++)
        free((char *)app->rubric.files[i]);
    image_destroy(&app->composed);
    rubric_destroy(&app->rubric);
}

const char *app_title(const App *app) {
    if (app->table.title[0] || !app->rubric.title)
        return app->table.title;
    return app->rubric.title;
}

FeedKind app_other(const App *app) {
    return view_state_needs_truth(&app->state) ? FEED_TRUTH : FEED_REFERENCE;
}

static bool needs(const App *app, FeedKind kind) {
    return kind == FEED_MINE        ? view_state_needs_mine(&app->state)
           : kind == FEED_REFERENCE ? view_state_needs_reference(&app->state)
                                    : view_state_needs_truth(&app->state);
}

static bool is_settled(const App *app, FeedKind kind) {
    return !app->feeds[kind].running || app->news[kind].dead || app->news[kind].answered >= app->asked[kind];
}

static bool all_settled(const App *app) {
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++)
        if (needs(app, kind) && !is_settled(app, kind))
            return false;
    return true;
}

void app_renew(App *app) {
    for (int i = 0; i < FEED_COUNT; i++)
        if (app->feeds[i].running)
            feed_renew(&app->feeds[i]);
}

static void look_at_files(App *app, double now) {
    if (now - app->looked < LOOK_EVERY)
        return;
    app->looked = now;
    for (int i = 0; i < 2; i++) // in the order of FEED_MINE, FEED_REFERENCE
        if (app->feeds[i].running && file_watch_found(&app->watches[i]))
            feed_renew(&app->feeds[i]);
    check_clear(); // a folder that is just being replaced
}

static void look_at_feeds(App *app) {
    app->heard = false;
    for (int i = 0; i < FEED_COUNT; i++)
        if (app->feeds[i].running) {
            uint64_t before = app->news[i].changes;
            feed_look(&app->feeds[i], &app->news[i]);
            app->heard = app->heard || app->news[i].changes != before;
        }
    FeedKind source = app->news[FEED_MINE].described ? FEED_MINE : FEED_REFERENCE;
    app->table = app->news[source].description;
}

// True when a picture that is shown is new. Pictures change together: only when all are there.
static bool take_pictures(App *app) {
    bool fresh = false;
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++)
        if (app->feeds[kind].running && app->taken[kind] != app->news[kind].pictures &&
            feed_take(&app->feeds[kind], &app->pictures[kind])) {
            app->taken[kind] = app->news[kind].pictures;
            fresh = fresh || needs(app, kind);
        }
    return fresh;
}

// What the lab's visibility is: that of its lights or, in a lab that has an occlusion to show, of the sky.
static const char *truth_view(const App *app) {
    for (int i = 0; i < app->table.stage_count; i++)
        if (strstr(app->table.stages[i], VIEW_OCCLUSION))
            return VIEW_OCCLUSION;
    return VIEW_VISIBILITY;
}

// Asks a feed for the request, if it does not know it.
static void ask(App *app, FeedKind kind) {
    Request request = app->request;
    if (!app->feeds[kind].running || app->asked[kind] == app->number)
        return;
    if (kind == FEED_TRUTH)
        snprintf(request.view, sizeof request.view, "%s", truth_view(app));
    feed_ask(&app->feeds[kind], &request, app->number);
    app->asked[kind] = app->number;
}

// A new request, once all have answered the old one. False when there is nothing new to ask for.
static bool renew_request(App *app, int width, int height) {
    Request request;
    if (!view_state_request(&app->state, width, height, &request) || view_state_same(&request, &app->request))
        return false;
    app->request = request;
    app->number++;
    return true;
}

static void ask_all(App *app) {
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++)
        if (needs(app, kind))
            ask(app, kind);
}

// Is `composed` still what the state wants to see of the pictures? Before they are all there, only the split
// moves.
static bool is_outdated(const App *app, bool done) {
    const ViewState *state = &app->state, *was = &app->shown;
    bool same_pictures = state->show == was->show && state->against_truth == was->against_truth;
    return same_pictures ? state->split != was->split : done;
}

static void recompose(App *app) {
    app->shown = app->state;
    app->difference = compose(&app->composed, app->state.show, &app->pictures[FEED_MINE],
                              &app->pictures[app_other(app)], app->state.split);
}

bool app_tick(App *app, int width, int height) {
    double now = process_now(), step = now - app->last;
    app->last = now;
    look_at_files(app, now);
    look_at_feeds(app);
    if (app->state.running)
        app->state.time += fmin(step, LONGEST_STEP);
    bool done = all_settled(app);
    bool fresh = (done && take_pictures(app)) || is_outdated(app, done);
    if (fresh)
        recompose(app);
    bool changed = done && renew_request(app, width, height);
    ask_all(app);
    if (done && !changed && !app->state.running)
        ask(app, FEED_REFERENCE); // for its time, and for the next key
    app->settled = done && !changed && all_settled(app) && app->number > 0;
    return fresh;
}

void app_notice(App *app, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(app->notice, sizeof app->notice, format, arguments);
    va_end(arguments);
    app->notice_until = process_now() + NOTICE_FOR;
}
