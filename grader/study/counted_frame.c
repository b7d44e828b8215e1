#include "study/counted_frame.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

// One worker for all frames of an artist; another of its folders gets another.
static WorkerClient *client_of(LabArtist *artist) {
    const char *folder = artist->painter ? artist->painter->folder : artist->client.folder;
    if (strcmp(artist->counter.folder, folder) != 0) {
        worker_client_stop(&artist->counter);
        artist->counter = (WorkerClient){.trust = artist->painter ? TRUST_OURS : TRUST_NOBODY,
                                         .jail = artist->client.jail,
                                         .seconds = artist->client.seconds};
        snprintf(artist->counter.folder, sizeof artist->counter.folder, "%s", folder);
    }
    return &artist->counter;
}

bool counted_frame(LabArtist *artist, const Request *request, MeasuredErrors *errors) {
    static Request asked;
    static Reply reply;
    static Image image;
    WorkerClient *client = client_of(artist);
    DrawResult result = DRAW_OK;
    asked = *request;
    asked.counted = COUNTED_READS;
    lab_artist_leave_out(artist, &asked.scene);
    for (asked.fresh = 1; result == DRAW_OK && asked.fresh >= 0; asked.fresh--)
        result = worker_client_draw(client, &asked, &image, &reply);
    if (result != DRAW_OK)
        return !artist->painter || check_fail("lab %s could not draw: %s (while it was counted)",
                                              artist->rubric.id, reply.message);
    errors->reads = reply.counts.taps;
    errors->fragments = reply.counts.fragments;
    errors->cleared = reply.counts.texels;
    return true;
}
