// worker CONTEXT LAB_FOLDER SHARED_SHADER_FOLDER [PATH]...
//
// Loads LAB_FOLDER/lab.so and draws the frames that a client asks for (protocol.h). It never talks to anybody
// else, so whatever a lab does to its process, the client only sees pixels of known size, an end of file or a
// silence. With LAB_FOLDER "-" each request names its lab: for ours, which may share a process. With "?" it
// is a nursery (nursery.h), and more arguments are paths that its children see.
#include "worker/renderdoc.h"
#include "context.h"
#include "worker/counted.h"
#include "worker/loaded_lab.h"
#include "worker/no_programs.h"
#include "worker/warm_up.h"
#include "worker/nursery.h"
#include "worker/ready_program.h"
#include "protocol/protocol.h"
#include "scene/shader_source.h"
#include "base/pipe.h"
#include "scene/count.h"

#include <execinfo.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct {
    bool ready; // the context is there
    ContextKind context;
    const char *lab_folder, *shader_folder;
    StageView stage_view;
} worker;

// Only what a handler may call: the record lies ready and is written as it is.
static void report_crash(int number) {
    static Reply crash = {.magic = PROTOCOL_CRASHED};
    void *frames[32];
    memcpy(crash.pass, loaded_lab_running(), sizeof crash.pass);
    crash.place = gl_caller(frames, backtrace(frames, 32));
    pipe_write(PROTOCOL_REPLIES, &crash, sizeof crash);
    signal(number, SIG_DFL);
    raise(number);
}

static void watch_crashes(void) {
    static char stack[64 * 1024]; // a stack of its own: an endless recursion has used up the other
    void *frame;
    backtrace(&frame, 1); // loads libgcc now, not inside the handler
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = report_crash, .sa_flags = SA_ONSTACK | SA_RESETHAND};
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU};
    for (unsigned i = 0; i < COUNT(signals); i++)
        sigaction(signals[i], &action, NULL);
}

static void fill_reply(Reply *reply, bool drawn) {
    reply->magic = PROTOCOL_MAGIC;
    reply->drawn = drawn;
    snprintf(reply->message, sizeof reply->message, "%s", check_message());
    reply->place = gl_error_place();
    if (gl_error()[0])
        check_append(reply->message, sizeof reply->message, "%s%s", reply->message[0] ? "; " : "",
                     gl_error());
    if (glad_glGetString)
        snprintf(reply->renderer, sizeof reply->renderer, "%s / %s (%s)",
                 (const char *)glGetString(GL_VERSION), (const char *)glGetString(GL_RENDERER),
                 context_route(worker.context));
}

static bool perform(const Request *request, Reply *reply, void *payload) {
    bool named = strcmp(worker.lab_folder, "-") == 0;
    check_clear();
    if (request->counted && !counted_is_on() && !counted_start(request->counted))
        return false;
    LoadedLab *hosted = loaded_lab_find(named ? request->folder : worker.lab_folder, worker.shader_folder);
    if (!hosted)
        return check_fail("too many labs in one worker");
    if (request->describe)
        return loaded_lab_describe(hosted, payload);
    const bool drawn = loaded_lab_draw(hosted, &worker.stage_view, request, reply, payload);
    reply->counts = counted_end();
    return drawn;
}

static bool answer(const Request *request) {
    static Reply reply;
    size_t bytes =
        request->describe ? sizeof(Description) : (size_t)request->width * (size_t)request->height * 4;
    void *payload = calloc(bytes, 1);
    if (!payload)
        return false;
    memset(&reply, 0, sizeof reply);
    renderdoc_begin();
    bool done = perform(request, &reply, payload);
    renderdoc_end();
    fill_reply(&reply, done);
    bool sent =
        pipe_write(PROTOCOL_REPLIES, &reply, sizeof reply) && pipe_write(PROTOCOL_REPLIES, payload, bytes);
    free(payload);
    return sent;
}

// Names begin at another number for each kind of object: who takes one for another must not be lucky.
static void spread_names(void) {
    GLuint names[400];
    glGenTextures(100, names);
    glGenSamplers(200, names);
    glGenRenderbuffers(300, names);
    glGenFramebuffers(400, names);
}

static bool start(const char *context) {
    if (!context_parse(&worker.context, context) || !context_create(worker.context))
        return false;
    spread_names();
    return draw_create() && stage_view_create(&worker.stage_view);
}

// Before any code of a lab's has run, so that a client believes it.
static bool greet(void) {
    static Reply reply;
    fill_reply(&reply, worker.ready);
    reply.magic = PROTOCOL_READY;
    return pipe_write(PROTOCOL_REPLIES, &reply, sizeof reply);
}

int main(int count, char **arguments) {
    static Request request;
    static char folder[PROTOCOL_PATH];
    const bool nursery = count > 4 && strcmp(arguments[2], "?") == 0;
    if (count != 4 && !nursery) {
        fprintf(stderr, "usage: worker osmesa|egl LAB_FOLDER SHARED_SHADER_FOLDER (started by the grader)\n");
        return 2;
    }
    watch_crashes();
    setvbuf(stdout, NULL, _IOLBF, 0); // what a lab prints is seen at once
    worker.lab_folder = arguments[2];
    worker.shader_folder = arguments[3];
    shader_source_folders(worker.shader_folder, worker.shader_folder); // for our own
    worker.ready = start(arguments[1]);
    if (nursery) {
        if (!worker.ready || !warm_up(&worker.stage_view) || !ready_program_create() ||
            !nursery_wait(folder, sizeof folder, arguments + 4, count - 4))
            return !worker.ready;
        worker.lab_folder = folder;
    }
    no_programs();
    if (!greet() || !worker.ready)
        return 1;
    while (pipe_read(PROTOCOL_REQUESTS, &request, sizeof request)) {
        INVARIANT(request.magic == PROTOCOL_MAGIC && request.width <= PROTOCOL_MAX_SIZE &&
                  request.height <= PROTOCOL_MAX_SIZE);
        if (!answer(&request))
            return 1;
    }
    loaded_lab_destroy();
    return 0;
}
