// worker CONTEXT LAB_FOLDER SHARED_SHADER_FOLDER
//
// Loads LAB_FOLDER/lab.so and draws the frames that a client asks for (protocol.h). It never talks to anybody else, so
// whatever a lab does to its process, the client only sees pixels of known size, an end of file or a silence.
#include "context.h"
#include "protocol.h"
#include "shader_source.h"
#include "stage_view.h"

#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static struct {
    const Lab *lab;
    Program programs[LAB_MAX_PROGRAMS];
    int program_count;
    Target picture, readback;
    StageView stage_view;
    bool ready;   // context, lab and programs are there
    bool created; // lab->create was called
    float knobs[LAB_MAX_KNOBS];
    const char *pass; // the one that runs, for the crash report
} worker;

static void report_crash(int number) {
    char text[300] = "";
    void *frames[32];
    check_append(text, sizeof text, "in %s", worker.pass ? worker.pass : "the lab");
    gl_append_caller(text, sizeof text, frames, backtrace(frames, 32));
    ssize_t written = write(STDERR_FILENO, text, strlen(text));
    (void)written;
    signal(number, SIG_DFL);
    raise(number);
}

static void watch_crashes(void) {
    static char stack[64 * 1024]; // a stack of its own: an endless recursion has used up the other
    void *frame;
    backtrace(&frame, 1); // loads libgcc now, not inside the handler
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = report_crash, .sa_flags = SA_ONSTACK | SA_RESETHAND};
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (unsigned i = 0; i < sizeof signals / sizeof signals[0]; i++)
        sigaction(signals[i], &action, NULL);
}

static bool load_lab(const char *folder) {
    char path[4096];
    snprintf(path, sizeof path, "%s/lab.so", folder);
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return check_fail("the lab cannot be loaded: %s", dlerror());
    worker.lab = dlsym(library, "lab");
    if (!worker.lab || !worker.lab->create || !worker.lab->destroy)
        return check_fail("lab.c defines no complete table `const Lab lab`; restore it from the skeleton");
    return true;
}

static bool load_programs(void) {
    for (const ProgramFiles *files = worker.lab->programs; files->vertex; files++) {
        if (!program_create(&worker.programs[worker.program_count], files))
            return false;
        worker.program_count++;
    }
    return true;
}

static bool start(const char *context, const char *lab_folder, const char *shader_folder) {
    ContextKind kind;
    shader_source_folders(lab_folder, shader_folder);
    worker.ready = context_parse(&kind, context) && context_create(kind) && draw_create() &&
                   stage_view_create(&worker.stage_view) && load_lab(lab_folder) && load_programs();
    return worker.ready;
}

static void destroy_lab(void) {
    if (worker.created)
        worker.lab->destroy();
    worker.created = false;
    target_destroy(&worker.picture);
    target_destroy(&worker.readback);
}

static int find_knob(const char *name) {
    for (int i = 0; i < LAB_MAX_KNOBS && worker.lab->knobs[i].name; i++)
        if (strncmp(worker.lab->knobs[i].name, name, LAB_MAX_NAME) == 0)
            return i;
    return -1;
}

static bool take_knobs(const Request *request, float *knobs) {
    for (int i = 0; i < LAB_MAX_KNOBS && worker.lab->knobs[i].name; i++)
        knobs[i] = worker.lab->knobs[i].value;
    for (int i = 0; i < request->knob_count; i++) {
        int knob = find_knob(request->knobs[i].name);
        if (knob < 0)
            return check_fail("the lab has no knob \"%s\"; restore the table of knobs", request->knobs[i].name);
        knobs[knob] = request->knobs[i].value;
    }
    return true;
}

// The lab's resources fit one size and one setting of the knobs.
static bool ensure_created(const Request *request, Frame *frame) {
    float knobs[LAB_MAX_KNOBS] = {0};
    if (!take_knobs(request, knobs))
        return false;
    bool fits = worker.created && worker.picture.width == request->width &&
                worker.picture.height == request->height && memcmp(knobs, worker.knobs, sizeof knobs) == 0;
    memcpy(worker.knobs, knobs, sizeof knobs);
    if (fits) {
        frame->framebuffer = worker.picture.framebuffer;
        return true;
    }
    destroy_lab();
    if (!target_create(&worker.readback, request->width, request->height, GL_RGBA32F, 0) ||
        !target_create(&worker.picture, request->width, request->height, GL_RGBA32F, GL_DEPTH24_STENCIL8))
        return false;
    frame->framebuffer = worker.picture.framebuffer;
    worker.created = true;
    worker.pass = "create";
    gl_reset();
    return worker.lab->create(frame) || check_fail("create returned false");
}

static float cpu_milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now); // that of the process ticks coarsely under RLIMIT_CPU
    return (float)((double)(now.tv_sec % 100000) * 1e3 + (double)now.tv_nsec / 1e6);
}

static void run_passes(const Frame *frame, float *milliseconds) {
    gl_reset();
    draw_to_frame(frame);
    vec3s background = frame->flat_light ? vec3_make(0, 0, 0) : frame->scene->background;
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    for (int i = 0; i < LAB_MAX_PASSES && worker.lab->passes[i].name; i++) {
        float start = cpu_milliseconds();
        worker.pass = worker.lab->passes[i].name;
        worker.lab->passes[i].draw(frame);
        glFinish();
        milliseconds[i] = cpu_milliseconds() - start;
    }
    worker.pass = NULL;
}

// 8 bits a channel, top row first; a pixel with a NaN or an infinity gets alpha 0.
static void quantise(const float *colors, uint8_t *pixels, int width, int height) {
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const float *from = colors + 4 * ((size_t)(height - 1 - y) * (size_t)width + (size_t)x);
            uint8_t *to = pixels + 4 * ((size_t)y * (size_t)width + (size_t)x);
            bool finite = isfinite(from[0]) && isfinite(from[1]) && isfinite(from[2]);
            for (int c = 0; c < 3; c++)
                to[c] = finite ? (uint8_t)(fminf(fmaxf(from[c], 0), 1) * 255 + 0.5f) : 0;
            to[3] = finite ? 255 : 0;
        }
}

static bool read_pixels(const Target *target, uint8_t *pixels) {
    float *colors = malloc((size_t)target->width * (size_t)target->height * 4 * sizeof *colors);
    if (!colors)
        return check_fail("out of memory for the picture");
    gl_reset();
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, colors);
    quantise(colors, pixels, target->width, target->height);
    free(colors);
    return true;
}

static bool show_view(const Request *request, uint8_t *pixels) {
    if (strcmp(request->view, VIEW_PICTURE) == 0 || strcmp(request->view, VIEW_VISIBILITY) == 0)
        return read_pixels(&worker.picture, pixels);
    for (int i = 0; i < LAB_MAX_STAGES && worker.lab->stages[i].name; i++)
        if (strncmp(worker.lab->stages[i].name, request->view, LAB_MAX_NAME) == 0) {
            stage_view_draw(&worker.stage_view, &worker.readback, *worker.lab->stages[i].texture);
            return read_pixels(&worker.readback, pixels);
        }
    return check_fail("the lab has no stage \"%s\"; restore the table of stages", request->view);
}

static bool draw_frame(const Request *request, Reply *reply, uint8_t *pixels) {
    if (!worker.ready)
        return false;
    check_clear();
    gl_clear_error();
    Frame frame = {.scene = &request->scene,
                   .programs = worker.programs,
                   .knobs = worker.knobs,
                   .width = request->width,
                   .height = request->height,
                   .flat_light = strcmp(request->view, VIEW_VISIBILITY) == 0};
    if (!ensure_created(request, &frame))
        return false;
    run_passes(&frame, reply->milliseconds);
    return show_view(request, pixels);
}

static bool transfer(int descriptor, void *data, size_t size, bool sending) {
    for (size_t done = 0; done < size;) {
        char *at = (char *)data + done;
        ssize_t n = sending ? write(descriptor, at, size - done) : read(descriptor, at, size - done);
        if (n <= 0 && !(n < 0 && errno == EINTR))
            return false;
        done += n > 0 ? (size_t)n : 0;
    }
    return true;
}

static void fill_reply(Reply *reply, bool drawn) {
    reply->magic = PROTOCOL_MAGIC;
    reply->drawn = drawn;
    snprintf(reply->message, sizeof reply->message, "%s", check_message());
    if (gl_error()[0])
        check_append(reply->message, sizeof reply->message, "%s%s", reply->message[0] ? "; " : "", gl_error());
    if (glad_glGetString)
        snprintf(reply->renderer, sizeof reply->renderer, "%s / %s", (const char *)glGetString(GL_VERSION),
                 (const char *)glGetString(GL_RENDERER));
}

static bool answer(const Request *request) {
    static Reply reply;
    size_t bytes = (size_t)request->width * (size_t)request->height * 4;
    uint8_t *pixels = calloc(bytes, 1);
    if (!pixels)
        return false;
    memset(&reply, 0, sizeof reply);
    bool drawn = draw_frame(request, &reply, pixels);
    fill_reply(&reply, drawn);
    bool sent = transfer(PROTOCOL_REPLIES, &reply, sizeof reply, true) &&
                transfer(PROTOCOL_REPLIES, pixels, bytes, true);
    free(pixels);
    return sent;
}

int main(int count, char **arguments) {
    static Request request;
    if (count != 4) {
        fprintf(stderr, "usage: worker osmesa|egl LAB_FOLDER SHARED_SHADER_FOLDER (started by the grader)\n");
        return 2;
    }
    watch_crashes();
    worker.pass = "the start";
    start(arguments[1], arguments[2], arguments[3]);
    while (transfer(PROTOCOL_REQUESTS, &request, sizeof request, false)) {
        INVARIANT(request.magic == PROTOCOL_MAGIC && request.width <= PROTOCOL_MAX_SIZE &&
                  request.height <= PROTOCOL_MAX_SIZE);
        if (!answer(&request))
            return 1;
    }
    destroy_lab();
    return 0;
}
