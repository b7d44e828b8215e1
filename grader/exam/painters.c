#include "exam/painters.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "compile/rubric_fit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool same_task(Solved a, Solved b) {
    return a.which == b.which && (a.task == b.task || (a.task && b.task && strcmp(a.task, b.task) == 0));
}

static bool ensure_worker(Painters *painters) {
    if (painters->client.started)
        return true;
    painters->client = (WorkerClient){.folder = "-",
                                      .trust = TRUST_OURS,
                                      .context = painters->context,
                                      .quick_shaders = !painters->measures,
                                      .hardware = painters->measures};
    return worker_client_start(&painters->client);
}

const Painter *painters_get(Painters *painters, Solved solved, const Change *change) {
    for (int i = 0; i < painters->count; i++)
        if (same_task(painters->painters[i]->solved, solved) && painters->painters[i]->change == change)
            return painters->painters[i];
    INVARIANT(painters->count < EXAM_MAX_PAINTERS);
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

bool painters_fit(Painters *painters) {
    static Request request;
    static Reply reply;
    static Description lab;
    if (!rubric_fit_sources(painters->rubric))
        return false;
    const Painter *solution = painters_get(painters, (Solved){SOLVED_ALL, NULL}, NULL);
    if (!solution)
        return false;
    request = (Request){.magic = PROTOCOL_MAGIC};
    INVARIANT(snprintf(request.folder, sizeof request.folder, "%s", solution->folder) <
              (int)sizeof request.folder);
    if (worker_client_describe(&painters->client, &request, &lab, &reply) != DRAW_OK)
        return check_fail("our own lab in %s does not say what it is: %s", solution->folder, reply.message);
    return rubric_fit_lab(painters->rubric, &lab);
}

void painters_destroy(Painters *painters) {
    worker_client_stop(&painters->client);
    for (int i = 0; i < painters->count; i++)
        free(painters->painters[i]);
    painters->count = 0;
}
