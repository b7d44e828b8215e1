// One small function a key, and the table that names them all.
#include "window/keys.h"

#include "scene/check.h"
#include "scene/count.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <math.h>

static const float TURN = 0.05F, ZOOM = 0.08F; // radians, logarithms
static const double TIME_STEP = 0.1;           // seconds

// Can this be shown, if need be by going to where a reference was recorded? Else a notice says why not.
static bool has(App *app, FeedKind kind) {
    if (app->feeds[kind].running || kind == FEED_MINE)
        return true;
    if (kind == FEED_REFERENCE && app->recorded.seed_count > 0) {
        if (app_recorded_enter(app))
            return true;
        app_notice(app, "%s", check_message());
        return false;
    }
    app_notice(app, "%s", app->absent[kind]);
    return false;
}

static void show(App *app, Show what) {
    const bool compares = what == SHOW_SPLIT || what == SHOW_DIFFERENCE;
    FeedKind kind = what == SHOW_MINE ? FEED_MINE : what == SHOW_TRUTH ? FEED_TRUTH : FEED_REFERENCE;
    if (compares && app->state.against_truth)
        kind = FEED_TRUTH;
    if (has(app, kind))
        app->state.show = what;
}

static void show_mine(App *app, int sign) {
    (void)sign, show(app, SHOW_MINE);
}

static void show_reference(App *app, int sign) {
    (void)sign, show(app, SHOW_REFERENCE);
}

static void show_split(App *app, int sign) {
    (void)sign, show(app, SHOW_SPLIT);
}

static void show_difference(App *app, int sign) {
    (void)sign, show(app, SHOW_DIFFERENCE);
}

static void show_truth(App *app, int sign) {
    (void)sign, show(app, SHOW_TRUTH);
}

static void change_rival(App *app, int sign) {
    (void)sign;
    FeedKind kind = app->state.against_truth ? FEED_REFERENCE : FEED_TRUTH;
    if (!has(app, kind))
        return;
    app->state.against_truth = kind == FEED_TRUTH;
    app_notice(app, "split and difference compare with the %s", kind == FEED_TRUTH ? "truth" : "reference");
}

static void move_split(App *app, int sign) {
    app->state.split = fminf(fmaxf(app->state.split + 0.02F * (float)sign, 0), 1);
}

static void select_knob(App *app, int sign) {
    view_state_select_knob(&app->state, &app->table, sign);
}

static void step_knob(App *app, int sign) {
    view_state_step_knob(&app->state, &app->table, sign, false);
}

static void step_knob_finely(App *app, int sign) {
    view_state_step_knob(&app->state, &app->table, sign, true);
}

static void reset_knob(App *app, int sign) {
    (void)sign, view_state_reset_knob(&app->state, &app->table, false);
}

static void reset_knobs(App *app, int sign) {
    (void)sign, view_state_reset_knob(&app->state, &app->table, true);
}

static void step_view(App *app, int sign) {
    view_state_step_view(&app->state, &app->table, sign);
}

static void step_scene(App *app, int sign) {
    view_state_step_scene(&app->state, &app->rubric, sign);
}

static void step_check(App *app, int sign) {
    if (app->rubric.check_count == 0)
        app_notice(app, "no checks here: the rubric is not handed out");
    if (app_recorded_shows(app))
        app_recorded_step(app, sign, 0);
    else
        view_state_step_check(&app->state, &app->rubric, sign);
}

static void step_seed(App *app, int sign) {
    if (app_recorded_shows(app))
        app_recorded_step(app, 0, sign);
    else if (app->state.seed > 1 || sign > 0)
        app->state.seed += (uint64_t)(int64_t)sign;
}

static void turn_camera(App *app, int sign) {
    app->state.camera.azimuth += TURN * (float)sign;
}

static void raise_camera(App *app, int sign) {
    app->state.camera.elevation += TURN * (float)sign;
}

static void zoom_camera(App *app, int sign) {
    app->state.camera.zoom += ZOOM * (float)sign;
}

static void turn_light(App *app, int sign) {
    app->state.light.azimuth += TURN * (float)sign;
}

static void raise_light(App *app, int sign) {
    app->state.light.elevation += TURN * (float)sign;
}

static void reset_orbits(App *app, int sign) {
    (void)sign, view_state_reset_orbits(&app->state);
}

static void run_time(App *app, int sign) {
    (void)sign;
    app->state.running = !app->state.running;
}

static void step_time(App *app, int sign) {
    app->state.running = false;
    app->state.time += TIME_STEP * sign;
}

static void change_pixel(App *app, int sign) {
    int pixel = app->state.pixel + sign;
    app->state.pixel = pixel < 1 ? 1 : pixel > STATE_MAX_PIXEL ? STATE_MAX_PIXEL : pixel;
}

static void rebuild(App *app, int sign) {
    (void)sign;
    app_renew(app);
    app_notice(app, "building again");
}

static void change_text(App *app, int sign) {
    (void)sign;
    app->state.text = !app->state.text;
}

static void change_loupe(App *app, int sign) {
    (void)sign;
    app->state.loupe = !app->state.loupe;
}

static void change_volumes(App *app, int sign) {
    (void)sign;
    app->state.volumes = !app->state.volumes;
}

static void change_light_shown(App *app, int sign) {
    (void)sign;
    app->state.light_shown = (app->state.light_shown + 1) % LIGHT_SHOWN_COUNT;
}

static void change_help(App *app, int sign) {
    (void)sign;
    app->state.help++;
}

// A key with Shift (1), without (0) or either way (-1). Rows of the help stand with the first key of a group.
typedef struct Action {
    int key, shift;
    void (*run)(App *app, int sign);
    int sign;
    bool repeats;
    const char *keys, *meaning;
} Action;

static const Action actions[] = {
    {GLFW_KEY_1, -1, show_mine, 0, false, "1", "mine"},
    {GLFW_KEY_2, -1, show_reference, 0, false, "2", "the reference"},
    {GLFW_KEY_3, -1, show_split, 0, false, "3", "both, with a split: drag it, or [ and ]"},
    {GLFW_KEY_4, -1, show_difference, 0, false, "4", "difference: yellow false light, blue false shadow"},
    {GLFW_KEY_5, -1, show_truth, 0, false, "5", "the truth, by rays: visibility"},
    {GLFW_KEY_T, -1, change_rival, 0, false, "T", "compare (3, 4) with the reference, or with the truth"},
    {GLFW_KEY_LEFT_BRACKET, -1, move_split, -1, true, NULL, NULL},
    {GLFW_KEY_RIGHT_BRACKET, -1, move_split, 1, true, NULL, NULL},
    {GLFW_KEY_V, 0, step_view, 1, false, "V", "next view: picture, visibility, the lab's stages"},
    {GLFW_KEY_V, 1, step_view, -1, false, NULL, NULL},
    {GLFW_KEY_C, 0, step_check, 1, false, "C", "next check of the grader: its scene, knobs and view"},
    {GLFW_KEY_C, 1, step_check, -1, false, NULL, NULL},
    {GLFW_KEY_N, 0, step_seed, 1, false, "N", "next variant of the scene (seed)"},
    {GLFW_KEY_N, 1, step_seed, -1, false, NULL, NULL},
    {GLFW_KEY_PAGE_DOWN, -1, step_scene, 1, false, "Page Up, Down", "another scene"},
    {GLFW_KEY_PAGE_UP, -1, step_scene, -1, false, NULL, NULL},
    {GLFW_KEY_UP, -1, select_knob, -1, true, "Up, Down", "choose a knob"},
    {GLFW_KEY_DOWN, -1, select_knob, 1, true, NULL, NULL},
    {GLFW_KEY_LEFT, 0, step_knob, -1, true, "Left, Right", "turn it; with Shift finely"},
    {GLFW_KEY_RIGHT, 0, step_knob, 1, true, NULL, NULL},
    {GLFW_KEY_LEFT, 1, step_knob_finely, -1, true, NULL, NULL},
    {GLFW_KEY_RIGHT, 1, step_knob_finely, 1, true, NULL, NULL},
    {GLFW_KEY_BACKSPACE, 0, reset_knob, 0, false, "Backspace", "its default; with Shift those of all knobs"},
    {GLFW_KEY_BACKSPACE, 1, reset_knobs, 0, false, NULL, NULL},
    {GLFW_KEY_A, -1, turn_camera, -1, true, "drag, or A D W S",
     "turn the camera; with Shift drag it sideways"},
    {GLFW_KEY_D, -1, turn_camera, 1, true, NULL, NULL},
    {GLFW_KEY_W, -1, raise_camera, 1, true, NULL, NULL},
    {GLFW_KEY_S, -1, raise_camera, -1, true, NULL, NULL},
    {GLFW_KEY_E, -1, zoom_camera, -1, true, "wheel, or E Q", "nearer, farther"},
    {GLFW_KEY_Q, -1, zoom_camera, 1, true, NULL, NULL},
    {GLFW_KEY_J, -1, turn_light, -1, true, "right drag, or J L I K", "move the light"},
    {GLFW_KEY_L, -1, turn_light, 1, true, NULL, NULL},
    {GLFW_KEY_I, -1, raise_light, 1, true, NULL, NULL},
    {GLFW_KEY_K, -1, raise_light, -1, true, NULL, NULL},
    {GLFW_KEY_SPACE, -1, run_time, 0, false, "Space", "let the light swing, or stop it"},
    {GLFW_KEY_PERIOD, -1, step_time, 1, true, "comma, period", "a step of time back, on"},
    {GLFW_KEY_COMMA, -1, step_time, -1, true, NULL, NULL},
    {GLFW_KEY_R, -1, reset_orbits, 0, false, "R", "camera, light and time as the scene has them"},
    {GLFW_KEY_EQUAL, -1, change_pixel, 1, false, "+ -", "larger or smaller pixels (larger ones are faster)"},
    {GLFW_KEY_KP_ADD, -1, change_pixel, 1, false, NULL, NULL},
    {GLFW_KEY_MINUS, -1, change_pixel, -1, false, NULL, NULL},
    {GLFW_KEY_KP_SUBTRACT, -1, change_pixel, -1, false, NULL, NULL},
    {GLFW_KEY_X, -1, change_volumes, 0, false, "X", "shadow volumes as haze: red looks to you, blue away"},
    {GLFW_KEY_G, -1, change_light_shown, 0, false, "G", "what the light's map sees; again: its texels, too"},
    {GLFW_KEY_Z, -1, change_loupe, 0, false, "Z", "a magnifying glass at the mouse"},
    {GLFW_KEY_H, -1, change_text, 0, false, "H", "hide or show the text"},
    {GLFW_KEY_F5, -1, rebuild, 0, false, "F5", "build again (saving a file does it, too)"},
    {GLFW_KEY_F1, -1, change_help, 0, false, "F1", "these keys"},
};

enum { ACTION_COUNT = COUNT(actions) };

// What the window itself does.
static const struct {
    Wish wish;
    int key;
    const char *keys, *meaning;
} wishes[] = {
    {WISH_SAVE, GLFW_KEY_P, "P", "save the picture as PNG"},
    {WISH_FULL_SCREEN, GLFW_KEY_F11, "F11", "full screen"},
    {WISH_QUIT, GLFW_KEY_ESCAPE, "Esc", "quit"},
};

enum { WISH_COUNT = COUNT(wishes) };

Wish keys_press(App *app, int key, int modifiers, bool repeated) {
    int shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    if (app->state.help && key == GLFW_KEY_ESCAPE) {
        app->state.help = 0;
        return WISH_NOTHING;
    }
    for (int i = 0; i < ACTION_COUNT; i++) {
        const Action *action = &actions[i];
        if (action->key == key && (action->shift < 0 || action->shift == shift) &&
            (action->repeats || !repeated))
            action->run(app, action->sign);
    }
    view_state_limit(&app->state);
    for (int i = 0; i < WISH_COUNT && !repeated; i++)
        if (wishes[i].key == key)
            return wishes[i].wish;
    return WISH_NOTHING;
}

bool keys_help(int row, const char **keys, const char **meaning) {
    for (int i = 0; i < ACTION_COUNT; i++)
        if (actions[i].keys && row-- == 0) {
            *keys = actions[i].keys;
            *meaning = actions[i].meaning;
            return true;
        }
    if (row >= WISH_COUNT)
        return false;
    *keys = wishes[row].keys;
    *meaning = wishes[row].meaning;
    return true;
}
