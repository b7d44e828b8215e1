// view: opens a lab in a window. The lab draws in a worker, as when it is graded; the window shows its
// pixels.
#include "arguments.h"
#include "check.h"
#include "home.h"
#include "hud.h"
#include "keys.h"
#include "screen.h"
#include "shader_source.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static const float FONT_HEIGHT = 15;                       // at a content scale of 1
static const double IDLE = 0.05, MOVING = 0.008, GRAB = 8; // seconds; seconds; window units beside the split

static struct {
    AppOptions options;
    App app;
    GLFWwindow *window;
    Screen screen;
    Text text;
    float scale; // of the monitor's contents
    double mouse_x, mouse_y, start;
    int buttons;      // bits
    bool drags_split; // since the button went down
    bool redraw;
    int saved; // pictures
    int windowed[4];
    bool failed;
    char told[200]; // the last problem that was printed
} view;

static volatile sig_atomic_t stopped; // by Ctrl-C: what was made for the labs is removed first

static void on_signal(int number) {
    (void)number;
    stopped = 1;
}

static void wake(void) {
    glfwPostEmptyEvent();
}

static void on_error(int code, const char *text) {
    (void)code;
    check_fail("the window: %s", text);
}

// Side of a pixel of the picture in those of the window.
static int pixel_side(void) {
    return view.app.state.pixel * (int)fmaxf(1, roundf(view.scale));
}

static void save_as(const char *path) {
    Image image = {0};
    int width, height;
    glfwGetFramebufferSize(view.window, &width, &height);
    Place place = place_picture(view.screen.width, view.screen.height, width, height, pixel_side());
    screen_draw(&view.screen, width, height, pixel_side());
    check_clear();
    bool ok = screen_read(&image, &place) && image_write_png(&image, path);
    app_notice(&view.app, ok ? "saved as %s" : "not saved: %s", ok ? path : check_message());
    printf("%s\n", view.app.notice);
    fflush(stdout);
    view.failed = view.failed || !ok;
    image_destroy(&image);
    view.redraw = true;
}

static void save(void) {
    char path[64];
    do
        snprintf(path, sizeof path, "shadow-lab-%s-%02d.png", view.app.rubric.id, ++view.saved);
    while (files_exists(path));
    save_as(path);
}

static void change_full_screen(void) {
    int *was = view.windowed;
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (glfwGetWindowMonitor(view.window)) {
        glfwSetWindowMonitor(view.window, NULL, was[0], was[1], was[2], was[3], GLFW_DONT_CARE);
    } else if (mode) {
        glfwGetWindowPos(view.window, &was[0], &was[1]);
        glfwGetWindowSize(view.window, &was[2], &was[3]);
        glfwSetWindowMonitor(view.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
}

static void on_key(GLFWwindow *window, int key, int code, int action, int modifiers) {
    (void)code;
    if (action == GLFW_RELEASE)
        return;
    view.redraw = true;
    switch (keys_press(&view.app, key, modifiers, action == GLFW_REPEAT)) {
    case WISH_QUIT:
        glfwSetWindowShouldClose(window, GLFW_TRUE);
        break;
    case WISH_SAVE:
        save();
        break;
    case WISH_FULL_SCREEN:
        change_full_screen();
        break;
    case WISH_NOTHING:
        break;
    }
}

static bool is_at_split(double x) {
    int width, height;
    glfwGetWindowSize(view.window, &width, &height);
    return view.app.state.show == SHOW_SPLIT && fabs(x - view.app.state.split * width) < GRAB;
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
    int width, height;
    glfwGetWindowSize(window, &width, &height);
    bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
    float dx = (float)((x - view.mouse_x) / fmax(height, 1)),
          dy = (float)((y - view.mouse_y) / fmax(height, 1));
    view.mouse_x = x;
    view.mouse_y = y;
    if (view.drags_split)
        view.app.state.split = fminf(fmaxf((float)(x / fmax(width, 1)), 0), 1);
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

// Text and pixels follow the monitor: on a HiDPI one both are larger.
static bool follow_scale(void) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(view.window, &x, &y);
    if (x == view.scale)
        return true;
    view.scale = x;
    text_destroy(&view.text);
    return text_create(&view.text, FONT_HEIGHT * x);
}

static bool open_window(void) {
    static char shaders[FILES_PATH], own_shaders[FILES_PATH];
    glfwSetErrorCallback(on_error);
    if (!glfwInit())
        return check_fail("no window can be opened: is there a display?");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    view.window =
        glfwCreateWindow(view.options.request.width, view.options.request.height, "Shadow Lab", NULL, NULL);
    if (!view.window)
        return check_fail("no window with OpenGL 4.1 can be opened");
    glfwMakeContextCurrent(view.window);
    glfwSwapInterval(1);
    home_path(shaders, "shaders");
    home_path(own_shaders, "grader/window");
    shader_source_folders(own_shaders, shaders);
    return gl_load((GLADloadfunc)glfwGetProcAddress) && screen_create(&view.screen) && follow_scale();
}

static void set_callbacks(void) {
    glfwSetKeyCallback(view.window, on_key);
    glfwSetMouseButtonCallback(view.window, on_button);
    glfwSetCursorPosCallback(view.window, on_cursor);
    glfwSetScrollCallback(view.window, on_scroll);
    glfwSetWindowRefreshCallback(view.window, on_refresh);
    glfwSetFramebufferSizeCallback(view.window, on_size);
}

// The mouse in pixels of the picture.
static void find_cursor(int cursor[2], int width, int height) {
    int units_x, units_y;
    glfwGetWindowSize(view.window, &units_x, &units_y);
    Place place = place_picture(view.screen.width, view.screen.height, width, height, pixel_side());
    double x = view.mouse_x * width / fmax(units_x, 1) - place.x,
           y = view.mouse_y * height / fmax(units_y, 1) - (height - place.y - place.height);
    cursor[0] = (int)floor(x * view.screen.width / fmax(place.width, 1));
    cursor[1] = (int)floor(y * view.screen.height / fmax(place.height, 1));
    if (!glfwGetWindowAttrib(view.window, GLFW_HOVERED))
        cursor[0] = cursor[1] = -1;
}

static void draw(int width, int height) {
    int cursor[2] = {-1, -1};
    char title[400];
    hud_title(&view.app, title, sizeof title);
    glfwSetWindowTitle(view.window, title);
    if (view.screen.width > 0)
        find_cursor(cursor, width, height);
    screen_draw(&view.screen, width, height, pixel_side());
    hud_put(&view.text, &view.app, width, height, cursor);
    text_draw(&view.text, width, height);
    glfwSwapBuffers(view.window);
    view.redraw = false;
}

// In the terminal, too, where a click on file:line opens the editor.
static void tell_problem(void) {
    const char *problem = view.app.news[FEED_MINE].problem;
    if (strncmp(problem, view.told, sizeof view.told - 1) == 0)
        return;
    snprintf(view.told, sizeof view.told, "%.199s", problem);
    if (problem[0])
        fprintf(stderr, "view: %s\n", problem);
}

static bool is_late(void) {
    for (int i = 0; i < FEED_COUNT; i++)
        if (view.app.news[i].busy_since > 0)
            return true;
    return false;
}

// One turn. False when the window is to close.
static bool turn(void) {
    int width, height;
    glfwWaitEventsTimeout(view.app.state.running ? MOVING : IDLE);
    glfwGetFramebufferSize(view.window, &width, &height);
    if (!follow_scale())
        return false;
    bool visible = width > 0 && height > 0 && !glfwGetWindowAttrib(view.window, GLFW_ICONIFIED);
    int pixel = pixel_side();
    if (visible &&
        app_tick(&view.app, width / pixel > 0 ? width / pixel : 1, height / pixel > 0 ? height / pixel : 1)) {
        screen_upload(&view.screen, &view.app.composed);
        view.redraw = true;
    }
    view.redraw = view.redraw || view.app.heard;
    tell_problem();
    if (visible && (view.redraw || is_late() || process_now() < view.app.notice_until + 1))
        draw(width, height);
    if (view.options.screenshot && view.app.settled) {
        save_as(view.options.screenshot);
        view.failed = view.failed || view.app.news[FEED_MINE].problem[0];
        return false;
    }
    bool over = view.options.quit_after > 0 && process_now() - view.start > view.options.quit_after;
    return !over && !stopped && !glfwWindowShouldClose(view.window);
}

static bool run(void) {
    view.start = process_now();
    bool ok = open_window() && app_create(&view.app, &view.options, wake);
    if (ok) {
        set_callbacks();
        glfwShowWindow(view.window);
    }
    while (ok && turn())
        ;
    app_destroy(&view.app);
    if (view.window) {
        text_destroy(&view.text);
        screen_destroy(&view.screen);
        glfwDestroyWindow(view.window);
    }
    glfwTerminate();
    return ok && !view.failed;
}

int main(int count, char **arguments) {
    signal(SIGPIPE, SIG_IGN);
    signal(SIGINT, on_signal);
    signal(SIGTERM, on_signal);
    signal(SIGHUP, on_signal);
    if (!arguments_parse(&view.options, count, arguments)) {
        fprintf(stderr, "view: %s\n%s", check_message(), arguments_usage);
        return 2;
    }
    bool ok = run();
    if (check_message()[0])
        fprintf(stderr, "view: %s\n", check_message());
    return ok ? 0 : 1;
}
