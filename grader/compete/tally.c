#include "compete/tally.h"

#include "points/own_points.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

static Request request_of(const Arena *arena, int setting, int camera, int counted) {
    const ArenaSetting *asked = &arena->settings[setting];
    Request request = {.magic = PROTOCOL_MAGIC,
                       .width = ARENA_WIDTH,
                       .height = ARENA_HEIGHT,
                       .fresh = 1, // so that nothing is left from a frame that was counted before
                       .counted = counted,
                       .knob_count = asked->knob_count,
                       .scene = arena->scenes[camera]};
    memcpy(request.knobs, asked->knobs, sizeof request.knobs);
    snprintf(request.view, sizeof request.view, "%s", asked->view);
    return request;
}

static bool draw(WorkerClient *client, const Request *request, Image *image, Reply *reply) {
    const bool drawn = worker_client_draw(client, request, image, reply) == DRAW_OK;
    if (reply->counts.uncounted[0])
        return check_fail("it works past what is counted: %s", reply->counts.uncounted);
    if (!drawn)
        return check_fail("it does not draw while it is counted: %.300s", reply->message);
    return reply->counts.counted == request->counted || check_fail("nothing was counted");
}

// What is missing to white where a pixel counts, a mean.
static void add_dark(ArenaTally *tally, const Image *image, const Image *truth) {
    double dark = 0, true_dark = 0, count = 0;
    for (size_t at = 0; at < image_bytes(truth); at += 4) {
        const uint8_t *right = truth->rgba + at;
        if (right[2] < 128)
            continue;
        dark += 1 - image->rgba[at] / 255.0;
        true_dark += 1 - (256 * right[0] + right[1]) / 65535.0;
        count++;
    }
    tally->dark += count > 0 ? dark / count / ARENA_CAMERAS : 0;
    tally->true_dark += count > 0 ? true_dark / count / ARENA_CAMERAS : 0;
}

bool tally_take(ArenaTally *tally, const Arena *arena, int setting, WorkerClient *client, int counted) {
    static Request request;
    static Reply reply;
    static Image image;
    static const double SHARE = 1.0 / ARENA_CAMERAS, PIXELS = (double)ARENA_WIDTH * ARENA_HEIGHT;
    *tally = (ArenaTally){0};
    for (int camera = 0; camera < ARENA_CAMERAS; camera++) {
        const Image *truth = &arena->truths[camera];
        request = request_of(arena, setting, camera, counted);
        if (!draw(client, &request, &image, &reply))
            return false;
        tally->taps += SHARE * reply.counts.taps / PIXELS;
        tally->fragments += SHARE * reply.counts.fragments / PIXELS;
        tally->texels += SHARE * reply.counts.texels / PIXELS;
        tally->error += SHARE * own_points_error(&image, truth);
        add_dark(tally, &image, truth);
    }
    return true;
}
