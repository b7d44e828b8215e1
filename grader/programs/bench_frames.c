// bench_frames: milliseconds of a lab's frames, of scoring and of writing PNG. For `make bench`; not a
// test.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "compile/lab_folder.h"
#include "exam/exam.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "base/statistics.h"
#include "score/score.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

enum { RUNS = 9 };

static void print_median(const char *name, double *milliseconds) {
    printf("%-44s %8.2f ms\n", name, statistics_median(milliseconds, RUNS));
}

// A new worker each time: its first frame, and another one after it.
static bool time_frames(const char *folder, const Request *request, Image *image, Trust trust,
                        const char *name) {
    static Reply reply;
    double first[RUNS], next[RUNS];
    char line[100];
    bool ok = true;
    for (int i = 0; ok && i < RUNS; i++) {
        WorkerClient client = {.trust = trust, .seconds = 60};
        snprintf(client.folder, sizeof client.folder, "%s", folder);
        double start = process_now();
        ok = worker_client_draw(&client, request, image, &reply) == DRAW_OK;
        first[i] = 1000 * (process_now() - start);
        start = process_now();
        ok = ok && worker_client_draw(&client, request, image, &reply) == DRAW_OK;
        next[i] = 1000 * (process_now() - start);
        worker_client_stop(&client);
    }
    if (!ok)
        return check_fail("the lab does not draw: %s", reply.message);
    snprintf(line, sizeof line, "start and first frame, %s", name);
    print_median(line, first);
    snprintf(line, sizeof line, "next frame, %s", name);
    print_median(line, next);
    return true;
}

static double clock_milliseconds(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec / 1e6;
}

// Processor time of a frame of 800 x 600 for the window: the passes, and what comes from drawing in a worker.
static bool time_window(const char *folder, const Request *small) {
    static Reply reply;
    Image image = {0};
    Request request = *small;
    WorkerClient client = {.trust = TRUST_OURS, .each_turn = true, .seconds = 60};
    double passes[RUNS], worker[RUNS], ours[RUNS];
    clockid_t clock = CLOCK_MONOTONIC;
    snprintf(client.folder, sizeof client.folder, "%s", folder);
    request.width = 800;
    request.height = 600;
    bool ok = worker_client_start(&client) && clock_getcpuclockid(client.process.pid, &clock) == 0;
    for (int i = -3; ok && i < RUNS; i++) { // the first ones pay for the shaders
        double start = clock_milliseconds(clock), our_start = clock_milliseconds(CLOCK_THREAD_CPUTIME_ID);
        ok = worker_client_draw(&client, &request, &image, &reply) == DRAW_OK;
        if (i < 0)
            continue;
        ours[i] = clock_milliseconds(CLOCK_THREAD_CPUTIME_ID) - our_start;
        passes[i] = (double)exam_milliseconds(&reply);
        worker[i] = clock_milliseconds(clock) - start - passes[i];
    }
    worker_client_stop(&client);
    image_destroy(&image);
    if (!ok)
        return check_fail("the lab does not draw: %s", reply.message);
    print_median("a frame of 800 x 600: its passes", passes);
    print_median("  reading it back and writing the pipe", worker);
    print_median("  reading the pipe", ours);
    return true;
}

static double kept; // so that the compiler keeps what is only timed

static bool time_scoring(const Image *image) {
    double score[RUNS], rmse[RUNS], png[RUNS];
    Image other = {0};
    bool ok = image_copy(&other, image);
    score_fill(&other, (const uint8_t[3]){0, 0, 0});
    for (int i = 0; ok && i < RUNS; i++) {
        double start = process_now();
        kept += score_frame(&other, image, image, &other).share;
        score[i] = 1000 * (process_now() - start);
        start = process_now();
        kept += score_rmse(&other, image);
        rmse[i] = 1000 * (process_now() - start);
        start = process_now();
        ok = image_write_png(image, "/dev/null");
        png[i] = 1000 * (process_now() - start);
    }
    image_destroy(&other);
    if (ok) {
        print_median("score of a frame", score);
        print_median("RMSE of a frame", rmse);
        print_median("PNG of a frame", png);
    }
    return ok;
}

static bool bench(const char *id) {
    static Request request = {.magic = PROTOCOL_MAGIC, .width = 160, .height = 128, .view = VIEW_PICTURE};
    char folder[FILES_PATH];
    Rubric rubric = {0};
    Image image = {0};
    bool ok = places_find_lab(folder, id) && rubric_load(&rubric, folder) &&
              scene_make(&request.scene, rubric.checks[0].scene, &(Random){1}) &&
              lab_folder_ours(folder, &rubric, (Solved){SOLVED_ALL, NULL}, NULL) &&
              time_frames(folder, &request, &image, TRUST_NOBODY, "new shaders") &&
              time_frames(folder, &request, &image, TRUST_OURS, "known shaders") &&
              time_window(folder, &request) && time_scoring(&image);
    image_destroy(&image);
    rubric_destroy(&rubric);
    return ok;
}

static bool check(void *settings, const Operands *operands) {
    if (option_lab(settings, operands->texts[0]))
        return true;
    char message[500];
    snprintf(message, sizeof message, "%s", check_message());
    check_clear();
    return check_fail("NN %s", message);
}

static const CommandLine command_line = {
    .program = "bench_frames",
    .forms = "NN",
    .about = "Times the frames of lab NN, scoring and writing PNG. For `make bench`; not a test.\n",
    .options = (const Option[]){{0}},
    .operand = "NN",
    .least = 1,
    .most = 1,
    .check = check,
};

int main(int count, char **arguments) {
    char lab[3];
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, lab, count, arguments);
    command_line_settle_context(&command_line, &context);
    if (bench(lab))
        return 0;
    fprintf(stderr, "bench_frames: %s\n", check_message());
    return 3;
}
