#include "exam/painters.h"

#include "scene/check.h"
#include "compile/lab_folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool same_task(Solved a, Solved b) {
    return a.which == b.which && (a.task == b.task || (a.task && b.task && strcmp(a.task, b.task) == 0));
}

static bool ensure_worker(Roster *roster) {
    if (roster->client.started)
        return true;
    roster->client =
        (Client){.folder = "-", .trust = TRUST_OURS, .context = roster->context, .quick_shaders = true};
    return client_start(&roster->client);
}

const Painter *roster_get(Roster *roster, Solved solved, const Change *change) {
    for (int i = 0; i < roster->count; i++)
        if (same_task(roster->painters[i]->solved, solved) && roster->painters[i]->change == change)
            return roster->painters[i];
    INVARIANT(roster->count < ROSTER_MAX);
    Painter *painter = calloc(1, sizeof *painter);
    INVARIANT(painter);
    *painter = (Painter){.solved = solved, .change = change};
    if (!ensure_worker(roster) || !derive_ours(painter->folder, roster->rubric, solved, change)) {
        free(painter);
        return NULL;
    }
    return roster->painters[roster->count++] = painter;
}

bool roster_draw(Roster *roster, const Painter *painter, const Request *request, Image *image, Reply *reply) {
    static Request named;
    named = *request;
    INVARIANT(snprintf(named.folder, sizeof named.folder, "%s", painter->folder) < (int)sizeof named.folder);
    DrawResult result = client_draw(&roster->client, &named, image, reply);
    return result == DRAW_OK || result == DRAW_FAILED ||
           check_fail("our own lab in %s could not draw: %s", painter->folder, reply->message);
}

void roster_destroy(Roster *roster) {
    client_stop(&roster->client);
    for (int i = 0; i < roster->count; i++)
        free(roster->painters[i]);
    roster->count = 0;
}
