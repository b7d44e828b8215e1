// The window's inside: three feeds, and the picture that they make together. Nothing here waits for a feed.
#pragma once

#include "window/captions.h"
#include "window/feed.h"
#include "window/recorded.h"
#include "window/view_state.h"
#include "base/file_watch.h"

#include <stdbool.h>

typedef struct AppOptions {
    char lab[3];                                         // "05"
    const char *submission, *check, *scene, *screenshot; // NULL: not given
    uint64_t seed;
    Show show;
    double quit_after, seconds; // 0: never; that a frame of mine may take
    Request request;            // size of the window in its own units, view and knobs
    ContextKind context;
    LightShown light_shown;
    bool against_truth, volumes, bare; // bare: without text
} AppOptions;

typedef struct App {
    const AppOptions *options;
    Rubric rubric;           // without checks when there is no solution here
    char folder[FILES_PATH]; // mine
    FileWatch watches[2];    // of mine, of the reference
    Feed feeds[FEED_COUNT];
    bool waiting[FEED_COUNT]; // it has not begun to build: mine comes first
    FeedNews news[FEED_COUNT];
    char absent[FEED_COUNT][200]; // why a feed does not run; "" when it does
    Image pictures[FEED_COUNT];
    bool heard;                 // the last tick has changed the news
    uint64_t taken[FEED_COUNT]; // number of the picture in `pictures`
    uint64_t asked[FEED_COUNT]; // number of the last request to each
    Request request, drawn;     // the newest; what `composed` shows
    uint64_t number;            // of `request`
    ViewState state;
    Description table; // of mine or, until it has one, of the reference
    Captions captions;
    Recorded recorded;  // where there are no solutions
    ViewState at_frame; // the state of the recorded frame that is open
    bool new_frame;     // it was opened since the last tick
    Image composed;
    ViewState shown; // when it was composed
    Difference difference;
    bool settled;        // `composed` is what the state asks for, as far as it can be had
    double last, looked; // process_now of the last tick, of the last look at the files
    char verdict[800];   // where to look first, from who owns the window (watch/view_verdict.h); "": nothing
    char notice[200];    // for a while: what a key has done
    double notice_until;
} App;

// Finds the lab and starts the feeds; `wake` is called from their threads. False with a message.
bool app_create(App *app, const AppOptions *options, void (*wake)(void));
void app_destroy(App *app); // accepts a zeroed app

// Looks for new pictures and files, asks for what the state needs, at this size in pixels. True when
// `composed` is new.
bool app_tick(App *app, int width, int height);

// Makes all feeds build and start again.
void app_renew(App *app);

// The lab's title: its own or, until it can tell, the rubric's.
const char *app_title(const App *app);

// The feed whose picture is "the other one" now.
FeedKind app_other(const App *app);

// Is the picture that the state asks for there, all of it? False with a message that says what is missing.
bool app_is_whole(const App *app);

// Do the pixels of `composed` lie where the scene's camera sees its points, so that one can draw on them?
bool app_shows_scene(const App *app);

// The view of which the truth is told: that of the lights or, in a lab that has an occlusion to show, of the
// sky.
const char *app_truth_view(const App *app);

// References without solutions are recorded, and are there only for what the grader asks: the state goes
// there. Does the reference that is shown come from a recording?
bool app_recorded_shows(const App *app);

// Lets the state be that of the recorded frame which is nearest to it. False with a message when there is
// none.
bool app_recorded_enter(App *app);

// Goes on to another check, or to another variant of it (1 or -1; 0: not).
void app_recorded_step(App *app, int checks, int variants);

// Once the state is no longer that of the frame, mine alone is shown.
void app_recorded_follow(App *app);

// Is the state what the options asked for, as far as they did? False with a message.
bool app_recorded_fits(const App *app);

// Says for a few seconds what a key has done.
void app_notice(App *app, const char *format, ...) __attribute__((format(printf, 2, 3)));
