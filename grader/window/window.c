// Asks GLFW for the window and its context, measures pixels against screen units, draws the picture, its text
// and the magnifying glass.
#include "window/window.h"

#include "scene/check.h"
#include "base/places.h"
#include "window/help.h"
#include "window/hud.h"
#include "window/marks.h"
#include "scene/shader_source.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <math.h>
#include <string.h>

static const float FONT_HEIGHT = 15, LEAST_FONT = 0.75F;  // at a scale of 1; of it, in a small window
static const float SMALL_WIDTH = 640, SMALL_HEIGHT = 480; // below, letters are smaller, at a scale of 1

#define REMEDY                                                                                               \
    "A window needs a display (over ssh: ssh -X). Without one look at pictures: make grade LAB=NN "          \
    "ARGS=\"--output wrong\""

static bool is_there; // GLFW found a display

static void on_error(int code, const char *text) {
    (void)code;
    if (!is_there)
        check_fail("no window can be opened: %s. " REMEDY, text);
    else
        check_fail("the window: %s", text);
}

static void ask_for_context(void) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

bool window_open(Window *window, int width, int height) {
    static char shaders[FILES_PATH], own_shaders[FILES_PATH];
    memset(window, 0, sizeof *window);
    glfwSetErrorCallback(on_error);
    is_there = glfwInit();
    if (!is_there)
        return check_fail("no window can be opened. " REMEDY);
    ask_for_context();
    window->handle = glfwCreateWindow(width, height, "Shadow Lab", NULL, NULL);
    if (!window->handle)
        return check_fail("no window with OpenGL 4.1 can be opened");
    glfwMakeContextCurrent(window->handle);
    glfwSwapInterval(1);
    places_path(shaders, "shaders");
    places_path(own_shaders, "grader/window");
    shader_source_folders(own_shaders, shaders);
    return gl_load((GLADloadfunc)glfwGetProcAddress) && screen_create(&window->screen) &&
           window_measure(window);
}

void window_close(Window *window) {
    if (window->handle) {
        text_destroy(&window->text);
        guides_destroy(&window->guides);
        screen_destroy(&window->screen);
        glfwDestroyWindow(window->handle);
    }
    window->handle = NULL;
    glfwTerminate();
}

bool window_measure(Window *window) {
    float x = 1, y = 1;
    glfwGetFramebufferSize(window->handle, &window->width, &window->height);
    glfwGetWindowContentScale(window->handle, &x, &y);
    const float fits = fminf((float)window->width / SMALL_WIDTH, (float)window->height / SMALL_HEIGHT) / x,
                letters = roundf(FONT_HEIGHT * x * fmaxf(LEAST_FONT, fminf(fits, 1)));
    window->scale = x;
    if (letters == window->letters)
        return true;
    window->letters = letters;
    text_destroy(&window->text);
    return text_create(&window->text, letters);
}

int window_pixel(const Window *window, int pixel) {
    return pixel * (int)fmaxf(1, roundf(window->scale));
}

Place window_place(const Window *window, const App *app) {
    const Screen *screen = &window->screen;
    if (screen->width == 0)
        return (Place){0};
    if (app_recorded_shows(app))
        return place_enlarged(screen->width, screen->height, window->width, window->height);
    return place_picture(screen->width, screen->height, window->width, window->height,
                         window_pixel(window, app->state.pixel));
}

int window_help_pages(const Window *window) {
    return help_pages(&window->text, window->width, window->height);
}

// From window units to pixels across.
static double across(const Window *window, double x) {
    int width, height;
    glfwGetWindowSize(window->handle, &width, &height);
    return x * window->width / fmax(width, 1);
}

float window_share(const Window *window, const App *app, double x) {
    const Place at = window_place(window, app);
    return (float)((across(window, x) - at.x) / fmax(at.width, 1));
}

void window_find(const Window *window, const App *app, double x, double y, int found[2]) {
    found[0] = found[1] = -1;
    if (window->screen.width == 0 || !glfwGetWindowAttrib(window->handle, GLFW_HOVERED))
        return;
    Place at = window_place(window, app);
    double left = across(window, x) - at.x;
    double top = across(window, y) - (window->height - at.y - at.height);
    found[0] = (int)floor(left * window->screen.width / fmax(at.width, 1));
    found[1] = (int)floor(top * window->screen.height / fmax(at.height, 1));
}

// The lab's map size, as its knob is set.
static float map_size(const App *app) {
    for (int i = 0; i < app->table.knob_count; i++)
        if (strcmp(app->table.knobs[i].name, "map size") == 0)
            return view_state_knob(&app->state, &app->table.knobs[i]);
    return 0;
}

bool window_take(Window *window, App *app) {
    const GuideWish wish = {app->state.volumes, app->state.light_shown, map_size(app)};
    const bool wanted = wish.volumes || wish.light != LIGHT_HIDDEN;
    if (wanted && app_shows_scene(app) && !guides_draw(&window->guides, &wish, &app->drawn, &app->composed))
        return false;
    screen_upload(&window->screen, &app->composed);
    return true;
}

static void draw_loupe(Window *window, const App *app, const int cursor[2]) {
    enum { ENLARGED = 8, BORDER = 2 };
    const Place whole = window_place(window, app);
    const int side = (int)fmax(1, whole.width / fmax(window->screen.width, 1));
    int size = (window->width < window->height ? window->width : window->height) / 5 * 2;
    Place at = {.width = size, .height = size};
    at.x = whole.x + cursor[0] * side - size / 2;
    at.y = whole.y + whole.height - cursor[1] * side - size / 2;
    text_box(&window->text, (float)(at.x - BORDER), (float)(window->height - at.y - size - BORDER),
             (float)(size + 2 * BORDER), (float)(size + 2 * BORDER), (Color){255, 214, 90, 255});
    text_draw(&window->text, window->width, window->height);
    screen_loupe(&window->screen, cursor, ENLARGED * side, &at);
    glViewport(0, 0, window->width, window->height);
}

static void draw_picture(const Window *window, const App *app) {
    const Place at = window_place(window, app);
    screen_draw(&window->screen, window->width, window->height, &at);
}

void window_draw(Window *window, const App *app, const int cursor[2]) {
    char title[400];
    hud_title(app, title, sizeof title);
    glfwSetWindowTitle(window->handle, title);
    draw_picture(window, app);
    if (app->state.loupe && window->screen.width > 0 && cursor[0] >= 0)
        draw_loupe(window, app, cursor);
    const Place at = window_place(window, app);
    marks_put(&window->text, app, &at, window->width, window->height);
    hud_put(&window->text, app, window->width, window->height, cursor);
    text_draw(&window->text, window->width, window->height);
    glfwSwapBuffers(window->handle);
}

bool window_save(Window *window, const App *app, const char *path) {
    Image image = {0};
    if (window->screen.width == 0)
        return check_fail("there is no picture yet");
    Place at = window_place(window, app);
    draw_picture(window, app);
    marks_put(&window->text, app, &at, window->width, window->height);
    text_draw(&window->text, window->width, window->height);
    bool ok = screen_read(&image, &at) && image_write_png(&image, path);
    image_destroy(&image);
    return ok;
}

void window_change_full_screen(Window *window) {
    int *was = window->before;
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (glfwGetWindowMonitor(window->handle)) {
        glfwSetWindowMonitor(window->handle, NULL, was[0], was[1], was[2], was[3], GLFW_DONT_CARE);
    } else if (mode) {
        glfwGetWindowPos(window->handle, &was[0], &was[1]);
        glfwGetWindowSize(window->handle, &was[2], &was[3]);
        glfwSetWindowMonitor(window->handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
}
