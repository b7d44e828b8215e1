// Loads lab.so and its shaders, makes its resources when size or knobs change, runs its passes with their
// times, and reads the pixels.
#include "worker/loaded_lab.h"

#include "base/limits.h"
#include "remark.h"
#include "worker/counted.h"
#include "worker/lab_table.h"
#include "worker/primitives_view.h"
#include "worker/quantise.h"
#include "worker/ready_program.h"
#include "scene/shader_source.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static LoadedLab *hosted_labs[EXAM_MAX_PAINTERS];
static const char NOTHING[] = "the lab";
static char running[LAB_MAX_NAME] = "the lab"; // a copy: what the lab holds may be damaged when it crashes

static void set_running(const char *what) {
    snprintf(running, sizeof running, "%s", what);
}

// Does the lab want a helper that only later labs are given? The list is that of grader/compile/given.
static bool explain_load(const char *folder, const char *error) {
    char path[4096], function[64], since[8];
    const char *symbol = strstr(error, "undefined symbol: ");
    snprintf(path, sizeof path, "%s/given/LATER", folder);
    FILE *later = symbol ? fopen(path, "r") : NULL;
    bool found = false;
    while (later && !found && fscanf(later, "%63s %7s", function, since) == 2)
        found = strcmp(symbol + strlen("undefined symbol: "), function) == 0;
    if (later)
        fclose(later);
    return found ? check_fail("lab.c uses %s, which is given from lab %s on: in this lab what it does is "
                              "yours to write",
                              function, since)
                 : check_fail("the lab cannot be loaded: %s", error);
}

static bool load_lab(LoadedLab *hosted) {
    char path[4096];
    snprintf(path, sizeof path, "%s/lab.so", hosted->folder);
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return explain_load(hosted->folder, dlerror());
    hosted->lab = dlsym(library, "lab");
    if (!hosted->lab || !hosted->lab->create || !hosted->lab->destroy)
        return check_fail("lab.c defines no complete table `const Lab lab`; restore it from the skeleton");
    return true;
}

static bool load_programs(LoadedLab *hosted) {
    INVARIANT(hosted->lab);
    for (int i = 0; i < LAB_MAX_PROGRAMS && hosted->lab->programs[i].vertex; i++) {
        if ((counted_is_on() || !ready_program_take(&hosted->programs[i], &hosted->lab->programs[i])) &&
            !program_create(&hosted->programs[i], &hosted->lab->programs[i]))
            return false;
        hosted->program_count++;
    }
    return true;
}

static bool load(LoadedLab *hosted, const char *shader_folder) {
    set_running("the start");
    shader_source_folders(hosted->folder, shader_folder);
    hosted->ready = load_lab(hosted) && load_programs(hosted);
    snprintf(hosted->failure, sizeof hosted->failure, "%s", check_message());
    set_running(NOTHING);
    return hosted->ready;
}

LoadedLab *loaded_lab_find(const char *folder, const char *shader_folder) {
    int i = 0;
    while (i < EXAM_MAX_PAINTERS && hosted_labs[i] && strcmp(hosted_labs[i]->folder, folder) != 0)
        i++;
    if (i == EXAM_MAX_PAINTERS)
        return NULL;
    if (!hosted_labs[i] && (hosted_labs[i] = calloc(1, sizeof *hosted_labs[i]))) {
        snprintf(hosted_labs[i]->folder, sizeof hosted_labs[i]->folder, "%s", folder);
        load(hosted_labs[i], shader_folder);
    }
    return hosted_labs[i];
}

static void destroy_lab(LoadedLab *hosted) {
    set_running("destroy");
    if (hosted->created)
        hosted->lab->destroy();
    set_running(NOTHING);
    hosted->created = false;
    target_destroy(&hosted->picture);
    target_destroy(&hosted->readback);
}

static int find_knob(const Lab *lab, const char *name) {
    for (int i = 0; i < LAB_MAX_KNOBS && lab->knobs[i].name; i++)
        if (strncmp(lab->knobs[i].name, name, LAB_MAX_NAME) == 0)
            return i;
    return -1;
}

static bool take_knobs(const Lab *lab, const Request *request, float *knobs) {
    for (int i = 0; i < LAB_MAX_KNOBS && lab->knobs[i].name; i++)
        knobs[i] = lab->knobs[i].value;
    for (int i = 0; i < request->knob_count; i++) {
        int knob = find_knob(lab, request->knobs[i].name);
        if (knob < 0)
            return check_fail("the lab has no knob \"%s\"; restore the table of knobs",
                              request->knobs[i].name);
        knobs[knob] = request->knobs[i].value;
    }
    return true;
}

static bool same_knobs(const float *a, const float *b) {
    for (int i = 0; i < LAB_MAX_KNOBS; i++)
        if (a[i] != b[i])
            return false;
    return true;
}

// The lab's resources fit one size and one setting of the knobs.
static bool ensure_created(LoadedLab *hosted, const Request *request, Frame *frame) {
    float knobs[LAB_MAX_KNOBS] = {0};
    if (!take_knobs(hosted->lab, request, knobs))
        return false;
    bool fits = hosted->created && !request->fresh && hosted->picture.width == request->width &&
                hosted->picture.height == request->height && same_knobs(knobs, hosted->knobs);
    memcpy(hosted->knobs, knobs, sizeof knobs);
    if (fits) {
        frame->framebuffer = hosted->picture.framebuffer;
        return true;
    }
    destroy_lab(hosted);
    gl_reset();
    if (!target_create(&hosted->readback, request->width, request->height, GL_RGBA32F, 0) ||
        !target_create(&hosted->picture, request->width, request->height, GL_RGBA32F, GL_DEPTH24_STENCIL8))
        return false;
    frame->framebuffer = hosted->picture.framebuffer;
    hosted->created = true;
    set_running("create");
    gl_reset(); // so that what a lab forgets to bind is not our picture
    counted_lab(true);
    const bool created = hosted->lab->create(frame);
    counted_lab(false);
    set_running(NOTHING);
    return created || check_fail("create returned false");
}

static float cpu_milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now); // that of the process ticks coarsely under RLIMIT_CPU
    return (float)((double)(now.tv_sec % 100000) * 1e3 + (double)now.tv_nsec / 1e6);
}

// The times of the GPU, read when all passes are done, so that no pass waits for the query of another one.
static void read_timers(const GLuint *timers, int count, float *milliseconds) {
    for (int i = 0; i < count; i++) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(timers[i], GL_QUERY_RESULT, &nanoseconds);
        milliseconds[i] = (float)((double)nanoseconds / 1e6);
    }
}

// What only shows a stage need not be drawn for the picture.
static bool is_seen(const Pass *pass, const char *view) {
    return pass->kind != PASS_SHOW ||
           (strcmp(view, VIEW_PICTURE) != 0 && strcmp(view, VIEW_VISIBILITY) != 0 &&
            strcmp(view, VIEW_PRIMITIVES) != 0);
}

static float run_pass(const Pass *pass, const Frame *frame, GLuint timer) {
    const float start = cpu_milliseconds();
    set_running(pass->name);
    if (timer)
        glBeginQuery(GL_TIME_ELAPSED, timer);
    remark_passes(true);
    counted_lab(true);
    if (is_seen(pass, frame->view))
        pass->draw(frame);
    counted_lab(false);
    remark_passes(false);
    if (timer)
        glEndQuery(GL_TIME_ELAPSED);
    glFinish();
    counted_collect();
    return cpu_milliseconds() - start;
}

// With `gpu_times` the passes are timed on the GPU, too.
static void run_passes(const Lab *lab, const Frame *frame, bool gpu_times, Reply *reply) {
    GLuint timers[LAB_MAX_PASSES] = {0};
    int count = 0;
    if (gpu_times)
        glGenQueries(LAB_MAX_PASSES, timers);
    gl_reset();
    frame_bind(frame);
    glDrawBuffer(GL_COLOR_ATTACHMENT0); // of the picture, in which an earlier frame may have left others
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    vec3s background = frame->flat_light ? vec3_make(0, 0, 0) : frame->scene->background;
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    for (; count < LAB_MAX_PASSES && lab->passes[count].name; count++)
        reply->milliseconds[count] = run_pass(&lab->passes[count], frame, timers[count]);
    set_running(NOTHING);
    if (!gpu_times)
        return;
    read_timers(timers, count, reply->gpu_milliseconds);
    glDeleteQueries(LAB_MAX_PASSES, timers);
}

static bool read_pixels(const Target *target, uint8_t *pixels) {
    float *colors = malloc((size_t)target->width * (size_t)target->height * 4 * sizeof *colors);
    if (!colors)
        return check_fail("out of memory for the picture");
    gl_reset();
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, colors);
    quantise(colors, pixels, target->width, target->height);
    free(colors);
    return true;
}

static bool show_view(const LoadedLab *hosted, const StageView *view, const Request *request,
                      const Frame *frame, FrameFacts *facts, uint8_t *pixels) {
    if (strcmp(request->view, VIEW_PRIMITIVES) == 0)
        return primitives_view_draw(frame) && read_pixels(&hosted->picture, pixels);
    if (strcmp(request->view, VIEW_PICTURE) == 0 || strcmp(request->view, VIEW_VISIBILITY) == 0)
        return read_pixels(&hosted->picture, pixels);
    for (int i = 0; i < LAB_MAX_STAGES && hosted->lab->stages[i].name; i++)
        if (strncmp(hosted->lab->stages[i].name, request->view, LAB_MAX_NAME) == 0) {
            stage_view_measure(*hosted->lab->stages[i].texture, facts);
            stage_view_draw(view, &hosted->readback, *hosted->lab->stages[i].texture,
                            request->own_shape == 1);
            return read_pixels(&hosted->readback, pixels);
        }
    return check_fail("the lab has no stage \"%s\"; restore the table of stages", request->view);
}

bool loaded_lab_draw(LoadedLab *hosted, const StageView *view, const Request *request, Reply *reply,
                     uint8_t *pixels) {
    check_clear();
    remark_clear();
    gl_clear_error();
    if (!hosted->ready)
        return check_fail("%s", hosted->failure);
    Frame frame = {.scene = &request->scene,
                   .programs = hosted->programs,
                   .knobs = hosted->knobs,
                   .width = request->width,
                   .height = request->height,
                   .flat_light = strcmp(request->view, VIEW_VISIBILITY) == 0,
                   .view = request->view};
    counted_begin();
    if (!ensure_created(hosted, request, &frame))
        return false;
    run_passes(hosted->lab, &frame, request->gpu_times, reply);
    snprintf(reply->remarks, sizeof reply->remarks, "%s", remark_text());
    reply->facts.refused = gl_refused();
    return show_view(hosted, view, request, &frame, &reply->facts, pixels);
}

bool loaded_lab_describe(const LoadedLab *hosted, Description *description) {
    memset(description, 0, sizeof *description);
    if (!hosted->lab)
        return check_fail("%s", hosted->failure);
    lab_table_describe(hosted->lab, description);
    return true;
}

const char *loaded_lab_running(void) {
    return running;
}

void loaded_lab_destroy(void) {
    for (int i = 0; i < EXAM_MAX_PAINTERS && hosted_labs[i]; i++) {
        destroy_lab(hosted_labs[i]);
        free(hosted_labs[i]);
        hosted_labs[i] = NULL;
    }
}
