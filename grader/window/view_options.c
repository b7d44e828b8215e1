#include "window/view_options.h"

#include "base/option_values.h"
#include "protocol/request_options.h"
#include "scene/check.h"
#include "window/app.h"

#include <string.h>

static bool take_show(void *target, const char *text) {
    static const char *const names[SHOW_COUNT] = {"mine", "reference", "split", "difference", "truth"};
    for (int i = 0; i < SHOW_COUNT; i++)
        if (strcmp(names[i], text) == 0) {
            *(Show *)target = (Show)i;
            return true;
        }
    return check_fail("takes mine, reference, split, difference or truth, not \"%s\"", text);
}

static bool take_light(void *target, const char *text) {
    static const char *const names[LIGHT_SHOWN_COUNT] = {"", "frustum", "texels"};
    for (int i = 1; i < LIGHT_SHOWN_COUNT; i++)
        if (strcmp(names[i], text) == 0) {
            *(LightShown *)target = (LightShown)i;
            return true;
        }
    return check_fail("takes frustum or texels, not \"%s\"", text);
}

#define AT(field) offsetof(AppOptions, field)
static const Option options[] = {
    {"lab", 0, "NN", "the lab", AT(lab), option_lab_of_student},
    {"submission", 0, "DIR", "shaped like labs/, or one lab's folder (default labs)", AT(submission),
     option_text},
    {"scene", 0, "NAME", "scene to begin with", AT(scene), option_text},
    {"check", 0, "TASK", "begin with the first check of a task: its scene, knobs and view", AT(check),
     option_text},
    {"seed", 0, "N", "variant of the scene (default 1)", AT(seed), option_seed},
    {"view", 0, "V", "picture (default), visibility or a stage of the lab", AT(request), request_take_view},
    {"show", 0, "S", "mine (default), reference, split, difference or truth", AT(show), take_show},
    {"against-truth", 0, NULL, "split and difference compare with the truth", AT(against_truth), option_flag},
    {"knob", 0, "NAME=VALUE", "may be repeated", AT(request), request_take_knob},
    {"size", 0, "WxH", "of the window (default 800x600)", AT(request), request_take_size},
    {"volumes", 0, NULL, "begin with shadow volumes as haze (key X)", AT(volumes), option_flag},
    {"light", 0, "W", "begin with what the light's map sees: frustum or texels (key G)", AT(light_shown),
     take_light},
    {"bare", 0, NULL, "begin without text (key H)", AT(bare), option_flag},
    {"timeout", 0, "S", "longest time of a frame of mine, in seconds (default 10)", AT(seconds),
     option_seconds},
    {"context", 0, "C", "of the labs: osmesa or egl (default: the first that is here)", AT(context),
     option_context},
    {"screenshot", 0, "FILE", "save the picture as PNG once it is there, and quit", AT(screenshot),
     option_text},
    {"quit-after", 0, "S", "quit after so many seconds", AT(quit_after), option_seconds},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    const AppOptions *app = settings;
    (void)operands;
    return app->lab[0] || check_fail("--lab NN is needed, as in: make run LAB=05");
}

const CommandLine view_command_line = {
    .program = "view",
    .forms = "--lab NN [options]",
    .about = "Opens a lab in a window. Key F1 shows the keys.\n",
    .options = options,
    .check = check,
};
