// Compiles a student's lab once, fixes a shader's choice as the setting asks, draws, and compares.
#include "points/own_points.h"

#include "base/statistics.h"
#include "compile/lab_folder.h"
#include "exam/exam.h"
#include "scene/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 5, SECONDS = 120 };

bool own_lab_open(OwnLab *lab, const Rubric *rubric, const char *folder, ContextKind context) {
    char log[COMPILE_LOG] = "";
    *lab =
        (OwnLab){.rubric = rubric, .client = {.trust = TRUST_NOBODY, .context = context, .seconds = SECONDS}};
    if (files_make_temporary(lab->client.folder) &&
        lab_folder_submission(lab->client.folder, rubric, folder, NULL, log))
        return true;
    own_lab_close(lab);
    return check_fail("%s", log);
}

void own_lab_close(OwnLab *lab) {
    worker_client_stop(&lab->client);
    if (lab->client.folder[0])
        files_remove(lab->client.folder);
    free(lab->original);
    lab->original = NULL;
    lab->client.folder[0] = '\0';
}

static void place(char path[FILES_PATH], const OwnLab *lab, const char *file) {
    files_join(path, lab->client.folder, file);
}

// The shaders as their author wrote them.
static bool restore(OwnLab *lab) {
    char path[FILES_PATH];
    if (!lab->edited)
        return true;
    place(path, lab, lab->edited);
    const bool ok = files_write(path, lab->original);
    free(lab->original);
    lab->original = NULL;
    lab->edited = NULL;
    return ok;
}

// Where the text still stands there: else the choice is left to the knob, which draws the same, only slower.
static bool edit(OwnLab *lab, const Edit *wanted) {
    char path[FILES_PATH];
    worker_client_stop(&lab->client);
    if (!restore(lab) || !wanted->file)
        return !wanted->file;
    place(path, lab, wanted->file);
    char *text = files_read(path, DERIVE_MAX_FILE), *edited = text ? task_blocks_edit(text, wanted) : NULL;
    check_clear();
    const bool ok = !edited || files_write(path, edited);
    free(edited);
    if (!edited)
        free(text);
    else
        lab->original = text, lab->edited = wanted->file;
    return ok;
}

static Request request_of(const Scene *scene, const RecordedPoint *point, const char *view, int width,
                          int height) {
    Request request = {.magic = PROTOCOL_MAGIC, .width = width, .height = height, .scene = *scene};
    snprintf(request.view, sizeof request.view, "%s", view);
    if (point)
        memcpy(request.knobs, point->knobs, sizeof request.knobs), request.knob_count = point->knob_count;
    return request;
}

static bool draw(OwnLab *lab, const Request *request, Image *image, Reply *reply) {
    return worker_client_draw(&lab->client, request, image, reply) == DRAW_OK ||
           check_fail("%.200s", reply->message);
}

// Median of some frames; the first one makes the lab's resources.
static bool time_frames(OwnLab *lab, const Request *request, double *milliseconds) {
    static Reply reply;
    static Image image;
    double times[FRAMES] = {0};
    bool ok = draw(lab, request, &image, &reply);
    for (int i = 0; ok && i < FRAMES; i++) {
        ok = draw(lab, request, &image, &reply);
        times[i] = (double)exam_milliseconds(&reply);
    }
    *milliseconds = statistics_median(times, FRAMES);
    return ok;
}

double own_points_error(const Image *frame, const Image *truth) {
    double sum = 0, count = 0;
    for (size_t at = 0; at < image_bytes(truth); at += 4) {
        const uint8_t *right = truth->rgba + at, *drawn = frame->rgba + at;
        const double light = (256 * right[0] + right[1]) / 65535.0;
        if (right[2] < 128)
            continue;
        sum += drawn[3] ? fabs(drawn[0] / 255.0 - light) : 1;
        count++;
    }
    return count > 0 ? sum / count : 0;
}

void own_lab_measure(OwnLab *lab, const RecordedPoint *point, const Scene *scene, const Image *truth,
                     OwnPoint *own) {
    static Reply reply;
    static Image image;
    const Request seen = request_of(scene, point, point->view, truth->width, truth->height),
                  timed = request_of(scene, point, VIEW_PICTURE, truth->width, truth->height);
    check_clear();
    *own = (OwnPoint){.drawn = edit(lab, &point->edit) && draw(lab, &seen, &image, &reply)};
    if (own->drawn)
        own->error = own_points_error(&image, truth);
    own->drawn = own->drawn && time_frames(lab, &timed, &own->milliseconds);
    if (!own->drawn)
        snprintf(own->message, sizeof own->message, "%s", check_message());
}

bool own_lab_yardstick(OwnLab *lab, const Scene *scene, int width, int height, double *milliseconds) {
    const Request request = request_of(scene, NULL, VIEW_PICTURE, width, height);
    const Edit none = {NULL, NULL, NULL};
    return edit(lab, &none) && time_frames(lab, &request, milliseconds) && *milliseconds > 0;
}
