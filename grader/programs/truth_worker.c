// truth_worker CONTEXT FOLDER SHADERS (started by the window; the arguments do not matter)
//
// Answers the requests of protocol.h with the truth: what the visibility view of a lab would show if it were
// right: the share of the scene's lights that reach a point; with VIEW_OCCLUSION, that of the sky; where
// there is dust in the air, the light that it sends to the eye.
#include "scene/check.h"
#include "base/command_line.h"
#include "truth/metrics.h"
#include "protocol/protocol.h"
#include "base/pipe.h"
#include "truth/truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SKY_RAYS = 256 };

typedef struct Job {
    Truth truth;
    TruthPicture picture;
    float *visibility;
} Job;

static float seen(const Scene *scene, const TruthHit *hit, float visibility) {
    return truth_facing(scene, hit, TRUTH_NONE) > METRICS_LEAST_FACING ? visibility : 0;
}

static void show(const Job *job, bool whole, uint8_t *pixels) {
    size_t count = (size_t)job->picture.width * (size_t)job->picture.height;
    for (size_t i = 0; i < count; i++) {
        float value =
            whole ? job->visibility[i] : seen(&job->truth.scene, &job->picture.hits[i], job->visibility[i]);
        memset(pixels + 4 * i, (uint8_t)lrintf(255 * fminf(value, 1)), 3);
        pixels[4 * i + 3] = 255;
    }
}

static float ray_length(const Request *request) {
    for (int i = 0; i < request->knob_count; i++)
        if (strcmp(request->knobs[i].name, "ray length") == 0)
            return request->knobs[i].value;
    return 0;
}

static TruthKind kind_of(const Request *request) {
    if (request->scene.medium.scattering > 0)
        return TRUTH_DUST;
    return strcmp(request->view, VIEW_OCCLUSION) == 0 ? TRUTH_OCCLUSION : TRUTH_LIGHTS;
}

static bool draw(Job *job, const Request *request, uint8_t *pixels) {
    TruthQuery query = {
        .kind = kind_of(request), .samples = SKY_RAYS, .limit = ray_length(request), .seed = 1};
    job->visibility = calloc((size_t)request->width * (size_t)request->height, sizeof *job->visibility);
    if (!job->visibility)
        return check_fail("out of memory for the truth");
    if (!truth_create(&job->truth, &request->scene) ||
        !truth_picture_create(&job->picture, request->width, request->height))
        return false;
    truth_look(&job->truth, &job->picture);
    if (!truth_trace(&job->truth, &job->picture, &query, job->visibility))
        return false;
    show(job, query.kind != TRUTH_LIGHTS, pixels);
    return true;
}

static bool answer(const Request *request, Reply *reply, void *payload) {
    Job job = {0};
    check_clear();
    bool drawn = request->describe ? check_fail("the truth has no knobs") : draw(&job, request, payload);
    truth_picture_destroy(&job.picture);
    truth_destroy(&job.truth);
    free(job.visibility);
    *reply = (Reply){.magic = PROTOCOL_MAGIC, .drawn = drawn, .renderer = "Embree"};
    snprintf(reply->message, sizeof reply->message, "%s", check_message());
    return drawn;
}

static const CommandLine command_line = {
    .program = "truth_worker",
    .forms = "[CONTEXT FOLDER SHADERS]",
    .about =
        "Answers the window's requests with the truth. The window starts it; its operands do not matter.\n",
    .options = (const Option[]){{0}},
    .operand = "operand",
    .most = 3,
};

int main(int count, char **arguments) {
    command_line_take(&command_line, NULL, count, arguments);
    static Request request;
    static Reply reply;
    reply = (Reply){.magic = PROTOCOL_READY, .drawn = true};
    if (!pipe_write(PROTOCOL_REPLIES, &reply, sizeof reply))
        return 1;
    while (pipe_read(PROTOCOL_REQUESTS, &request, sizeof request)) {
        INVARIANT(request.magic == PROTOCOL_MAGIC && request.width <= PROTOCOL_MAX_SIZE &&
                  request.height <= PROTOCOL_MAX_SIZE);
        size_t bytes =
            request.describe ? sizeof(Description) : (size_t)request.width * (size_t)request.height * 4;
        clock_t start = clock();
        void *payload = calloc(bytes, 1);
        bool ok = payload != NULL;
        if (ok)
            answer(&request, &reply, payload);
        reply.milliseconds[0] = 1000 * (float)(clock() - start) / CLOCKS_PER_SEC;
        ok = ok && pipe_write(PROTOCOL_REPLIES, &reply, sizeof reply) &&
             pipe_write(PROTOCOL_REPLIES, payload, bytes);
        free(payload);
        if (!ok)
            return 1;
    }
    return 0;
}
