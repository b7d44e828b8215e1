// sweep: draws one of our labs over one of its knobs in a scene of the study, and measures each frame against
// the truth; the site's sliders of real frames are made with it.
#include "scene/check.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "protocol/request_options.h"
#include "study/lab_artist.h"
#include "study/study_scene.h"
#include "study/truth_view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_VALUES = 32, ACROSS = 4 }; // rays of a pixel along a side, and that twice

typedef struct Sweep {
    char lab[3];
    const char *scene, *over;
    Request request; // size, and the knobs that stay
    const char *folder;
    double values[MAX_VALUES];
    int value_count;
} Sweep;

#define AT(field) offsetof(Sweep, field)
static const Option options[] = {{"lab", 0, "NN", "the lab", AT(lab), option_lab},
                                 {"scene", 0, "NAME", "a scene of the study", AT(scene), option_text},
                                 {"over", 0, "KNOB", "the knob that takes all values", AT(over), option_text},
                                 {"knob", 0, "NAME=VALUE", "another knob, for all frames; may be repeated",
                                  AT(request), request_take_knob},
                                 {"view", 0, "V",
                                  "what the pictures show: picture (default), visibility or a stage",
                                  AT(request), request_take_view},
                                 {"size", 0, "WxH", "default 480x360", AT(request), request_take_size},
                                 {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    Sweep *sweep = settings;
    if (!sweep->lab[0] || !sweep->scene || !sweep->over || operands->count < 2)
        return check_fail("--lab, --scene, --over, a folder and a value are needed");
    if (sweep->request.knob_count == LAB_MAX_KNOBS)
        return check_fail("--knob: too many");
    sweep->folder = operands->texts[0];
    sweep->value_count = operands->count - 1;
    for (int i = 0; i < sweep->value_count; i++)
        if (!option_decimal(&sweep->values[i], operands->texts[i + 1])) {
            check_clear();
            return check_fail("a value is a number, not \"%s\"", operands->texts[i + 1]);
        }
    return true;
}

static const CommandLine command_line = {
    .program = "sweep",
    .forms = "--lab NN --scene NAME --over KNOB [options] FOLDER VALUE...",
    .about = "Draws a lab's solution with each value of a knob to FOLDER/0.png, 1.png, ... and prints a line "
             "for each:\n"
             "the value, and the means of false shadow and false light over the pixels that count, 0 to 1.\n",
    .options = options,
    .operand = "FOLDER and its values",
    .most = MAX_VALUES + 1,
    .check = check,
};

static const StudyScene *find_scene(const char *name) {
    INVARIANT(name);
    for (int i = 0; study_scene(i); i++)
        if (strcmp(study_scene(i)->name, name) == 0)
            return study_scene(i);
    check_fail("--scene: the study has no \"%s\"", name);
    return NULL;
}

static bool write_picture(LabArtist *artist, const TruthView *truth_view, const Setting *setting,
                          const char *path) {
    static Reply reply;
    Image image = {0};
    const Request request = truth_view_request(truth_view, setting);
    bool ok = lab_artist_draw(artist, &request, &image, &reply) && image_write_png(&image, path);
    image_destroy(&image);
    return ok;
}

static bool draw_value(const Sweep *sweep, int i, LabArtist *artist, const TruthView *truth_view,
                       Setting setting) {
    Measured measured = {0};
    char name[16], path[FILES_PATH];
    setting_knob(&setting, sweep->over, (float)sweep->values[i]);
    Setting shown = setting;
    shown.view = sweep->request.view;
    snprintf(name, sizeof name, "%d.png", i);
    files_join(path, sweep->folder, name);
    bool ok = write_picture(artist, truth_view, &shown, path) &&
              truth_view_measure(truth_view, artist, &setting, false, &measured);
    const MetricsPart *all = &measured.metrics.all;
    if (ok)
        printf("%g,%.6f,%.6f\n", sweep->values[i], all->false_shadow, all->false_light);
    measured_destroy(&measured);
    return ok;
}

static bool run(const Sweep *sweep, const StudyScene *of, LabArtist *artist, TruthView *truth_view) {
    static Scene scene;
    const MetricsSize size = {sweep->request.width, sweep->request.height};
    Setting setting = {.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
    of->make(&scene);
    for (int i = 0; i < sweep->request.knob_count; i++)
        setting_knob(&setting, sweep->request.knobs[i].name, sweep->request.knobs[i].value);
    bool ok = lab_artist_open(artist, sweep->lab) &&
              truth_view_create(truth_view, &scene, size, &of->query, artist) &&
              truth_view_refine(truth_view, &of->query, ACROSS);
    for (int i = 0; ok && i < sweep->value_count; i++)
        ok = draw_value(sweep, i, artist, truth_view, setting);
    return ok;
}

int main(int count, char **arguments) {
    static Sweep sweep = {.request = {.width = 480, .height = 360, .view = "picture"}};
    static LabArtist artist;
    TruthView truth_view = {0};
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, &sweep, count, arguments);
    command_line_settle_context(&command_line, &context);
    char folder[FILES_PATH];
    snprintf(folder, sizeof folder, "%.4000s/", sweep.folder);
    const StudyScene *scene = find_scene(sweep.scene);
    bool ok = scene && files_make_folder(folder) && run(&sweep, scene, &artist, &truth_view);
    truth_view_destroy(&truth_view);
    lab_artist_close(&artist);
    if (!ok)
        fprintf(stderr, "sweep: %s\n", check_message());
    return ok ? 0 : 1;
}
