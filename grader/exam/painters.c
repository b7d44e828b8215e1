#include "exam/painters.h"

#include "scene/check.h"
#include "compile/lab_folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool same_task(Solved a, Solved b) {
    return a.which == b.which && (a.task == b.task || (a.task && b.task && strcmp(a.task, b.task) == 0));
}

static bool ensure_worker(Painters *painters) {
    if (painters->client.started)
        return true;
    painters->client = (WorkerClient){
        .folder = "-", .trust = TRUST_OURS, .context = painters->context, .quick_shaders = true};
    return worker_client_start(&painters->client);
}

const Painter *painters_get(Painters *painters, Solved solved, const Change *change) {
    for (int i = 0; i < painters->count; i++)
        if (same_task(painters->painters[i]->solved, solved) && painters->painters[i]->change == change)
            return painters->painters[i];
    INVARIANT(painters->count < ROSTER_MAX);
    Painter *painter = calloc(1, sizeof *painter);
    INVARIANT(painter);
    *painter = (Painter){.solved = solved, .change = change};
    if (!ensure_worker(painters) || !lab_folder_ours(painter->folder, painters->rubric, solved, change)) {
        free(painter);
        return NULL;
    }
    return painters->painters[painters->count++] = painter;
}

bool painters_draw(Painters *painters, const Painter *painter, const Request *request, Image *image,
                   Reply *reply) {
    static Request named;
    named = *request;
    int length = snprintf(named.folder, sizeof named.folder, "%s", painter->folder);
    INVARIANT(length < (int)sizeof named.folder);
    DrawResult result = worker_client_draw(&painters->client, &named, image, reply);
    return result == DRAW_OK || result == DRAW_FAILED ||
           check_fail("our own lab in %s could not draw: %s", painter->folder, reply->message);
}

void painters_destroy(Painters *painters) {
    worker_client_stop(&painters->client);
    for (int i = 0; i < painters->count; i++)
        free(painters->painters[i]);
    painters->count = 0;
}
