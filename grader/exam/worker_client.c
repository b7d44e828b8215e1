// Sends a request to a worker and takes exactly one reply; what comes instead (a crash, silence, nonsense)
// becomes a message for people.
#include "exam/worker_client.h"

#include "scene/check.h"
#include "base/context_choice.h"
#include "compile/compiler.h"
#include "exam/greeting.h"
#include "exam/nursery_client.h"
#include "protocol/description.h"
#include "base/places.h"
#include "scene/count.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

enum { MEMORY_MIB = 2048, MAX_RESTARTS = 16 };

#if defined(__SANITIZE_ADDRESS__)
static const bool limits_memory = false; // the sanitizer reserves terabytes of addresses
#else
static const bool limits_memory = true;
#endif

#define ADDRESS_OPTIONS                                                                                      \
    "ASAN_OPTIONS=detect_leaks=0:disable_coredump=0:handle_segv=2:handle_sigbus=2:handle_abort=2:fast_"      \
    "unwind_on_malloc=0:"                                                                                    \
    "allocator_may_return_null=1"

static double wall_seconds(const WorkerClient *client) {
    return client->seconds * (client->patience > 0 ? client->patience : 1);
}

// Appends what of our own environment says where EGL and its drivers are, up to `count` entries in all.
static int add_driver_settings(char **environment, int count, int most) {
    static const char *const names[] = {"SHADOW_LAB_EGL_DEVICE", "LD_LIBRARY_PATH",
                                        "__EGL_VENDOR_LIBRARY_FILENAMES", "LIBGL_DRIVERS_PATH",
                                        "LIBGL_ALWAYS_SOFTWARE"};
    for (unsigned i = 0; i < COUNT(names); i++)
        for (char **entry = environ; *entry; entry++) {
            const size_t length = strlen(names[i]);
            if (count < most && strncmp(*entry, names[i], length) == 0 && (*entry)[length] == '=')
                environment[count++] = *entry;
        }
    return count;
}

// A nursery's children are all of one kind.
static bool can_be_forked(const WorkerClient *client) {
    return client->trust == TRUST_NOBODY && client->jail && client->quick_shaders && !client->program &&
           !client->address && !client->each_turn && !client->hardware;
}

bool worker_client_start(WorkerClient *client) {
    char worker[FILES_PATH], shaders[FILES_PATH], cache[FILES_PATH], cache_setting[FILES_PATH + 32];
    if (client->program) // of ours, and outside
        places_build_path(worker, client->program);
    else
        jail_part(client->jail, client->address ? "worker_address" : "worker", worker);
    jail_part(client->jail, "shaders", shaders);
    places_build_path(cache, "cache/shaders");
    snprintf(cache_setting, sizeof cache_setting, "MESA_SHADER_CACHE_DIR=%s", cache);
    bool ours = client->trust == TRUST_OURS;
    const bool known = context_choose(&client->context);
    char *arguments[] = {worker, (char *)context_name(client->context), client->folder, shaders, NULL};
    enum { MOST_VARIABLES = 20 };
    char *environment[MOST_VARIABLES + 1] = {
        "LP_NUM_THREADS=0",
        client->address ? ADDRESS_OPTIONS : "ASAN_OPTIONS=detect_leaks=0:disable_coredump=0",
        "MALLOC_MMAP_THRESHOLD_=1000000000",
        "MALLOC_TRIM_THRESHOLD_=1000000000",
        "LC_ALL=C",
        ours ? cache_setting : "MESA_SHADER_CACHE_DISABLE=true"};
    int variables = 6;
    if (client->quick_shaders)
        environment[variables++] = "GALLIVM_PERF=nopt";
    if (client->quick_shaders && !ours)
        environment[variables++] = "LP_NATIVE_VECTOR_WIDTH=128";
    if (client->hardware)
        add_driver_settings(environment, variables, MOST_VARIABLES);
    else
        environment[variables++] = "LIBGL_ALWAYS_SOFTWARE=1";
    JailPlan plan = {
        .kind = JAIL_DRAW, .limits = {.wall_seconds = 3600}, .folder = ours ? "/" : client->folder};
    if (client->each_turn)
        plan.limits = (ProcessLimits){.wall_seconds = client->seconds,
                                      .memory_mib = !ours && limits_memory ? MEMORY_MIB : 0,
                                      .file_mib = ours ? 0 : 1};
    else if (!ours)
        plan.limits = (ProcessLimits){.wall_seconds = wall_seconds(client),
                                      .cpu_seconds = (unsigned)(client->seconds - client->used_seconds) + 1,
                                      .memory_mib = limits_memory ? MEMORY_MIB : 0,
                                      .file_mib = 1};
    if (client->address) { // its map of the memory takes terabytes of addresses: what is held counts
        plan.sees_itself = true;
        plan.limits.memory_mib = 0;
        plan.limits.resident_mib = MEMORY_MIB;
    }
    client->greeted = false;
    client->started = known && ((can_be_forked(client) && nursery_start(client->jail, client->context, &plan,
                                                                        &client->process, environment)) ||
                                jail_start(client->jail, &plan, &client->process, arguments, environment));
    client->fault = !client->started;
    return client->started;
}

// SIGXCPU can be ignored; a second later the kernel kills.
static bool used_up_its_time(const WorkerClient *client) {
    const Process *process = &client->process;
    int number = WIFSIGNALED(process->status) ? WTERMSIG(process->status) : 0;
    return process->state == PROCESS_TIMED_OUT || number == SIGXCPU ||
           (number == SIGKILL && !client->each_turn && client->seconds > 0 &&
            process->cpu_seconds >= client->seconds - client->used_seconds);
}

static void append_place(WorkerClient *client, const Request *request, Reply *reply) {
    const char *folder = strcmp(client->folder, "-") == 0 ? request->folder : client->folder;
    known_place_append(&client->place, folder, client->jail, reply);
}

// What the worker said of itself in its last record; a lab may have written that, or prevented it.
static void append_pass(WorkerClient *client, const Request *request, Reply *reply) {
    if (reply->magic != PROTOCOL_CRASHED)
        return;
    check_append(reply->message, sizeof reply->message, " in %s", reply->pass);
    append_place(client, request, reply);
}

static void explain_crash(WorkerClient *client, const Request *request, Reply *reply) {
    const Process *process = &client->process;
    snprintf(reply->message, sizeof reply->message, "it crashed: %s (%s)",
             strsignal(WTERMSIG(process->status)), sigabbrev_np(WTERMSIG(process->status)));
    append_pass(client, request, reply);
    if (process->peak_mib > MEMORY_MIB / 2)
        check_append(reply->message, sizeof reply->message,
                     "; it had used %ld MiB, and memory ends at %d MiB", process->peak_mib, MEMORY_MIB);
}

static DrawResult explain_end(WorkerClient *client, const Request *request, Reply *reply) {
    const Process *process = &client->process;
    char *text = reply->message;
    const size_t size = sizeof reply->message;
    if (process->state == PROCESS_FLOODED) {
        snprintf(text, size, "it printed more than %d MiB and was stopped", PROCESS_FLOOD / (1024 * 1024));
        return DRAW_LOST;
    }
    if (used_up_its_time(client)) {
        snprintf(text, size, "it was stopped after %.0f s", client->seconds);
        append_pass(client, request, reply);
        check_append(text, size, ": is there an endless loop?");
        return DRAW_TIMEOUT;
    }
    if (WIFSIGNALED(process->status))
        explain_crash(client, request, reply);
    else
        snprintf(text, size,
                 "it ended by itself with exit status %d before the frame was drawn; lab.c must return",
                 WEXITSTATUS(process->status));
    return DRAW_LOST;
}

static void clean_times(float milliseconds[LAB_MAX_PASSES]) {
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        if (!(milliseconds[i] >= 0 && milliseconds[i] < 1e9f))
            milliseconds[i] = 0;
}

// All of it is the submission's to write.
static void clean_reply(Reply *reply) {
    reply->remarks[sizeof reply->remarks - 1] = reply->message[sizeof reply->message - 1] =
        reply->renderer[sizeof reply->renderer - 1] = '\0';
    description_clean_text(reply->pass, sizeof reply->pass);
    clean_times(reply->milliseconds);
    clean_times(reply->gpu_milliseconds);
    reply->facts.refused = reply->facts.refused != 0;
    description_clean_counts(&reply->counts);
}

static void note_crash(WorkerClient *client, const Request *request) {
    const int status = client->process.status, number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (!client->has_crash && (number == SIGSEGV || number == SIGABRT || number == SIGBUS)) {
        client->has_crash = true;
        client->crash = *request;
    }
}

static bool is_ready(WorkerClient *client, Reply *reply) {
    if (!client->started && !worker_client_start(client))
        return false;
    client->greeted = client->greeted || greeting_hear(&client->process, reply);
    return client->greeted;
}

static DrawResult explain_fault(WorkerClient *client, void *payload, size_t size, Reply *reply) {
    char why[600];
    clean_reply(reply);
    snprintf(why, sizeof why, "%.590s",
             reply->message[0]                     ? reply->message
             : client->process.text[0]             ? client->process.text
             : !client->started                    ? check_message()
             : used_up_its_time(client)            ? "it takes too long"
             : WIFSIGNALED(client->process.status) ? strsignal(WTERMSIG(client->process.status))
                                                   : "it says nothing");
    memset(payload, 0, size);
    client->fault = true;
    snprintf(reply->message, sizeof reply->message, "no process that draws can be started or heard: %s", why);
    return DRAW_FAULT;
}

// Of a muted lab only its pixels are taken, and what we see of its end.
static void hush(WorkerClient *client, Reply *reply) {
    client->hushed = client->hushed || reply->message[0] || reply->remarks[0] || !reply->drawn;
    reply->remarks[0] = '\0';
    snprintf(reply->message, sizeof reply->message, "%s", reply->drawn ? "" : "it draws nothing");
    if (reply->magic == PROTOCOL_CRASHED)
        reply->magic = 0;
}

// The reply and exactly `size` bytes of payload; zeroes when they do not come.
static DrawResult exchange(WorkerClient *client, const Request *request, void *payload, size_t size,
                           Reply *reply) {
    memset(reply, 0, sizeof *reply);
    Process *process = &client->process;
    if (!is_ready(client, reply))
        return explain_fault(client, payload, size, reply);
    memset(reply, 0, sizeof *reply);
    bool ok = process_exchange(process, request, sizeof *request, reply, sizeof *reply) &&
              process_exchange(process, NULL, 0, payload, size);
    if (!ok && reply->magic != PROTOCOL_CRASHED && !process_take_rest(process, reply, sizeof *reply))
        memset(reply, 0, sizeof *reply);
    clean_reply(reply);
    if (!ok && process->state == PROCESS_DEAF)
        return explain_fault(client, payload, size, reply);
    if (client->muted)
        hush(client, reply);
    if (!ok) {
        memset(payload, 0, size);
        note_crash(client, request);
        return explain_end(client, request, reply);
    }
    if (reply->magic != PROTOCOL_MAGIC) {
        snprintf(reply->message, sizeof reply->message,
                 "it wrote something else than a frame to descriptor 3");
        return DRAW_LOST;
    }
    if (reply->message[0] && !client->muted)
        append_place(client, request, reply);
    return reply->drawn ? DRAW_OK : DRAW_FAILED;
}

DrawResult worker_client_draw(WorkerClient *client, const Request *request, Image *image, Reply *reply) {
    if (image->width != request->width || image->height != request->height) {
        image_destroy(image);
        bool created = image_create(image, request->width, request->height);
        INVARIANT(created);
    }
    return exchange(client, request, image->rgba, image_bytes(image), reply);
}

DrawResult worker_client_describe(WorkerClient *client, const Request *request, Description *description,
                                  Reply *reply) {
    Request asked = *request;
    asked.describe = 1;
    DrawResult result = exchange(client, &asked, description, sizeof *description, reply);
    if (result != DRAW_OK)
        memset(description, 0, sizeof *description);
    description_clean(description);
    return result;
}

void worker_client_begin(WorkerClient *client) {
    if (client->started && (client->trust == TRUST_NOBODY || client->each_turn))
        client->process.deadline = process_now() + wall_seconds(client);
}

bool worker_client_restart(WorkerClient *client) {
    const double deadline = client->process.deadline;
    const KnownPlace place = client->place;
    worker_client_stop(client);
    client->place = place; // the same lab.so
    client->used_seconds += client->process.cpu_seconds;
    if (++client->restarts > MAX_RESTARTS || client->used_seconds >= client->seconds ||
        process_now() >= deadline || !worker_client_start(client))
        return false;
    client->process.deadline = deadline;
    return true;
}

void worker_client_stop(WorkerClient *client) {
    if (client->started)
        process_stop(&client->process);
    client->started = client->greeted = client->fault = false;
    client->place.folder[0] = '\0';
}
