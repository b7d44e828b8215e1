// view: opens a lab in a window. The lab draws in a worker, as when it is graded; the window shows its
// pixels.
#include "window/view_options.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "scene/check.h"
#include "window/keys.h"
#include "diagnose/result.h"
#include "watch/view_verdict.h"
#include "window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <ctype.h>
#include <math.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

static const double IDLE = 0.05, MOVING = 0.008, GRAB = 8; // seconds; seconds; window units beside the split

static struct {
    AppOptions options;
    App app;
    Window window;
    ViewVerdict verdict;
    double mouse_x, mouse_y, start;
    int buttons;      // bits
    bool drags_split; // since the button went down
    bool redraw;
    atomic_bool opened;
    int saved; // pictures
    bool failed;
    char told[200]; // the last problem that was printed
} view;

static volatile sig_atomic_t stopped; // by Ctrl-C: what was made for the labs is removed first

static void on_signal(int number) {
    (void)number;
    stopped = 1;
}

// Feeds begin before the window is there.
static void wake(void) {
    if (view.opened)
        glfwPostEmptyEvent();
}

static void save_as(const char *path) {
    check_clear();
    bool ok = app_is_whole(&view.app) && window_save(&view.window, &view.app, path);
    app_notice(&view.app, ok ? "saved as %s" : "not saved: %s", ok ? path : check_message());
    printf("%s\n", view.app.notice);
    fflush(stdout);
    view.failed = view.failed || !ok;
    view.redraw = true;
}

static void save(void) {
    char path[64];
    do
        snprintf(path, sizeof path, "shadow-lab-%s-%02d.png", view.app.rubric.id, ++view.saved);
    while (files_exists(path));
    save_as(path);
}

// GLFW names keys by their place on an American keyboard; letters and signs are meant as they are printed.
static int printed_key(int key, int code) {
    const char *name = glfwGetKeyName(key, code);
    if (!name || !name[0] || name[1])
        return key;
    if (isalpha((unsigned char)name[0]) || strchr("-=,.[]", name[0]))
        return toupper((unsigned char)name[0]);
    return name[0] == '+' ? GLFW_KEY_EQUAL : key;
}

static void on_key(GLFWwindow *window, int key, int code, int action, int modifiers) {
    if (action == GLFW_RELEASE)
        return;
    view.redraw = true;
    switch (keys_press(&view.app, printed_key(key, code), modifiers, action == GLFW_REPEAT)) {
    case WISH_QUIT:
        glfwSetWindowShouldClose(window, GLFW_TRUE);
        break;
    case WISH_SAVE:
        save();
        break;
    case WISH_FULL_SCREEN:
        window_change_full_screen(&view.window);
        break;
    case WISH_NOTHING:
        break;
    }
    if (view.app.state.help > window_help_pages(&view.window))
        view.app.state.help = 0;
}

static bool is_at_split(double x) {
    int width;
    glfwGetWindowSize(view.window.handle, &width, NULL);
    const double away = window_share(&view.window, &view.app, x) - view.app.state.split;
    return view.app.state.show == SHOW_SPLIT && fabs(away * width) < GRAB;
}

// The pointer says that the split can be taken.
static void show_pointer(bool at_split) {
    static GLFWcursor *sideways; // made at the first call, freed by glfwTerminate
    if (!sideways)
        sideways = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
    glfwSetCursor(view.window.handle, at_split ? sideways : NULL);
}

static void on_button(GLFWwindow *window, int button, int action, int modifiers) {
    (void)window, (void)modifiers;
    if (action == GLFW_PRESS)
        view.buttons |= 1 << button;
    else
        view.buttons &= ~(1 << button);
    view.drags_split = view.buttons == 1 && is_at_split(view.mouse_x);
}

static void on_cursor(GLFWwindow *window, double x, double y) {
    int height;
    glfwGetWindowSize(window, NULL, &height);
    bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                 glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
    float dx = (float)((x - view.mouse_x) / fmax(height, 1));
    float dy = (float)((y - view.mouse_y) / fmax(height, 1));
    view.mouse_x = x;
    view.mouse_y = y;
    show_pointer(view.drags_split || (!view.buttons && is_at_split(x)));
    if (view.drags_split)
        view.app.state.split = fminf(fmaxf(window_share(&view.window, &view.app, x), 0), 1);
    else if (view.buttons)
        keys_drag(&view.app, view.buttons, shift ? GLFW_MOD_SHIFT : 0, dx, dy);
    view.redraw = true;
}

static void on_scroll(GLFWwindow *window, double x, double y) {
    (void)window, (void)x;
    keys_scroll(&view.app, (float)y);
    view.redraw = true;
}

static void on_refresh(GLFWwindow *window) {
    (void)window;
    view.redraw = true;
}

static void on_size(GLFWwindow *window, int width, int height) {
    (void)window, (void)width, (void)height;
    view.redraw = true;
}

static void set_callbacks(GLFWwindow *window) {
    glfwSetKeyCallback(window, on_key);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetFramebufferSizeCallback(window, on_size);
}

// In the terminal, too, where a click on file:line opens the editor.
static void tell_problem(void) {
    static char clean[2 * PROTOCOL_TEXT];
    const char *problem = view.app.news[FEED_MINE].problem;
    if (strncmp(problem, view.told, sizeof view.told - 1) == 0)
        return;
    snprintf(view.told, sizeof view.told, "%.199s", problem);
    result_clean(clean, sizeof clean, problem);
    if (problem[0])
        fprintf(stderr, "view: %s\n", clean);
}

// One line of where to look, in the window and in the terminal.
static void tell_verdict(void) {
    static char clean[2 * sizeof view.app.verdict];
    if (view.options.screenshot || !view_verdict_tick(&view.verdict, &view.app))
        return;
    view.redraw = true;
    result_clean(clean, sizeof clean, view.app.verdict);
    if (clean[0] && !view.verdict.grading.busy)
        printf("%s\n", clean);
    fflush(stdout);
}

// Something on the screen changes by itself: a clock of what is late, a notice that goes.
static bool is_restless(void) {
    for (int i = 0; i < FEED_COUNT; i++)
        if (view.app.news[i].busy_since > 0)
            return true;
    return process_now() < view.app.notice_until + 1;
}

static void draw(void) {
    int cursor[2];
    window_find(&view.window, &view.app, view.mouse_x, view.mouse_y, cursor);
    window_draw(&view.window, &view.app, cursor);
    view.redraw = false;
}

static int at_least_one(int value) {
    return value > 1 ? value : 1;
}

static void show(void) {
    const Window *window = &view.window;
    int pixel = window_pixel(window, view.app.state.pixel);
    if (app_tick(&view.app, at_least_one(window->width / pixel), at_least_one(window->height / pixel))) {
        if (!window_take(&view.window, &view.app))
            app_notice(&view.app, "%s", check_message());
        view.redraw = true;
    }
    if (view.redraw || view.app.heard || is_restless())
        draw();
}

// One turn. False when the window is to close.
static bool turn(void) {
    glfwWaitEventsTimeout(view.app.state.running ? MOVING : IDLE);
    if (!window_measure(&view.window))
        return false;
    if (view.window.width > 0 && view.window.height > 0 &&
        !glfwGetWindowAttrib(view.window.handle, GLFW_ICONIFIED))
        show();
    tell_problem();
    tell_verdict();
    if (view.options.screenshot && view.app.settled) {
        save_as(view.options.screenshot);
        view.failed = view.failed || view.app.news[FEED_MINE].problem[0];
        return false;
    }
    bool over = view.options.quit_after > 0 && process_now() - view.start > view.options.quit_after;
    return !over && !stopped && !glfwWindowShouldClose(view.window.handle);
}

static bool run(void) {
    const Request *size = &view.options.request;
    view.start = process_now();
    bool ok =
        app_create(&view.app, &view.options, wake) && window_open(&view.window, size->width, size->height);
    view.opened = ok;
    if (ok) {
        set_callbacks(view.window.handle);
        glfwShowWindow(view.window.handle);
    }
    while (ok && turn())
        ;
    view_verdict_stop(&view.verdict);
    app_destroy(&view.app);
    view.opened = false;
    window_close(&view.window);
    return ok && !view.failed;
}

int main(int count, char **arguments) {
    view.options = (AppOptions){.seed = 1, .seconds = 10, .request = {.width = 800, .height = 600}};
    command_line_take(&view_command_line, &view.options, count, arguments);
    command_line_settle_context(&view_command_line, &view.options.context);
    signal(SIGINT, on_signal);
    signal(SIGTERM, on_signal);
    signal(SIGHUP, on_signal);
    bool ok = run();
    if (check_message()[0])
        fprintf(stderr, "view: %s\n", check_message());
    return ok ? 0 : 1;
}
