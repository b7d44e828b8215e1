// At each tick: looks at saved files and new pictures, asks for what is missing, and composes.
#include "window/app.h"

#include "scene/check.h"
#include "window/counts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const double LOOK_EVERY = 0.05, NOTICE_FOR = 4, LONGEST_STEP = 0.5; // seconds

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
        if (app->feeds[i].running && !app->waiting[i])
            feed_renew(&app->feeds[i]);
}

// Lets a feed build that has waited for mine.
static void begin(App *app, FeedKind kind) {
    if (!app->waiting[kind] || !app->feeds[kind].running)
        return;
    app->waiting[kind] = false;
    feed_renew(&app->feeds[kind]);
}

static void look_at_files(App *app, double now) {
    if (now - app->looked < LOOK_EVERY)
        return;
    app->looked = now;
    for (int i = 0; i < 2; i++) // in the order of FEED_MINE, FEED_REFERENCE
        if (app->feeds[i].running && file_watch_found(&app->watches[i]) && !app->waiting[i])
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

const char *app_truth_view(const App *app) {
    for (int i = 0; i < app->table.stage_count; i++)
        if (strstr(app->table.stages[i], VIEW_OCCLUSION))
            return VIEW_OCCLUSION;
    return VIEW_VISIBILITY;
}

// Asks a feed for the request, if it does not know it.
static void ask(App *app, FeedKind kind) {
    Request request = app->request;
    begin(app, kind);
    if (!app->feeds[kind].running || app->asked[kind] == app->number)
        return;
    if (kind == FEED_TRUTH)
        snprintf(request.view, sizeof request.view, "%s", app_truth_view(app));
    feed_ask(&app->feeds[kind], &request, app->number);
    app->asked[kind] = app->number;
}

// A new request, once all have answered the old one. False when there is nothing new to ask for.
static bool renew_request(App *app, int width, int height) {
    Request request;
    if (app_recorded_shows(app))
        request = app->recorded.frame.request;
    else if (!view_state_request(&app->state, width, height, &request))
        return false;
    if (view_state_same(&request, &app->request))
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
    bool same_pictures = state->show == was->show && state->against_truth == was->against_truth &&
                         state->volumes == was->volumes && state->light_shown == was->light_shown &&
                         !app->new_frame;
    return same_pictures ? state->split != was->split : done;
}

static void recompose(App *app) {
    app->shown = app->state;
    app->difference = compose(&app->composed, app->state.show, &app->pictures[FEED_MINE],
                              &app->pictures[app_other(app)], app->state.split);
    if (counts_is_view(app->drawn.view) && app->state.show != SHOW_DIFFERENCE)
        counts_recolor(&app->composed);
    app->new_frame = false;
}

bool app_is_whole(const App *app) {
    static const char *const names[FEED_COUNT] = {"mine", "the reference", "the truth"};
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++) {
        const Image *picture = &app->pictures[kind];
        const bool recorded = kind == FEED_REFERENCE && app_recorded_shows(app);
        if (!needs(app, kind) || recorded)
            continue;
        if (!app->feeds[kind].running || app->news[kind].problem[0])
            return check_fail("%s is not there: %s", names[kind],
                              app->feeds[kind].running ? app->news[kind].problem : app->absent[kind]);
        if (!picture->rgba || picture->width != app->composed.width ||
            picture->height != app->composed.height)
            return check_fail("%s is not there yet", names[kind]);
    }
    return app->composed.rgba || check_fail("there is no picture yet");
}

bool app_shows_scene(const App *app) {
    const char *view = app->drawn.view;
    const FrameFacts *facts = &app->news[FEED_MINE].facts;
    if (app->composed.width != app->drawn.width || app->composed.height != app->drawn.height)
        return false;
    return strcmp(view, VIEW_PICTURE) == 0 || strcmp(view, VIEW_VISIBILITY) == 0 ||
           (facts->stage_width == app->drawn.width && facts->stage_height == app->drawn.height);
}

// The reference is drawn for its time, and for the next key; the truth begins, for the same.
static void prepare_others(App *app) {
    ask(app, FEED_REFERENCE);
    begin(app, FEED_TRUTH);
}

bool app_tick(App *app, int width, int height) {
    double now = process_now(), step = now - app->last;
    app->last = now;
    look_at_files(app, now);
    look_at_feeds(app);
    if (app->state.running)
        app->state.time += fmin(step, LONGEST_STEP);
    app_recorded_follow(app);
    bool done = all_settled(app), taken = done && take_pictures(app);
    if (done)
        app->drawn = app->request;
    bool fresh = taken || is_outdated(app, done);
    if (fresh)
        recompose(app);
    bool changed = done && renew_request(app, width, height);
    ask_all(app);
    if (done && !changed && !app->state.running)
        prepare_others(app);
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
