#include "roster.h"

#include "check.h"
#include "derive.h"

#include <stdlib.h>
#include <string.h>

static bool same_task(Solved a, Solved b) {
    return a.which == b.which && (a.task == b.task || (a.task && b.task && strcmp(a.task, b.task) == 0));
}

Client *roster_get(Roster *roster, Solved solved, const Change *change) {
    for (int i = 0; i < roster->count; i++)
        if (same_task(roster->entries[i].solved, solved) && roster->entries[i].change == change)
            return roster->entries[i].client;
    INVARIANT(roster->count < ROSTER_MAX);
    Client *client = calloc(1, sizeof *client);
    INVARIANT(client);
    client->context = roster->context;
    client->trust = TRUST_OURS;
    if (!derive_ours(client->folder, roster->rubric, solved, change) || !client_start(client)) {
        free(client);
        return NULL;
    }
    roster->entries[roster->count].solved = solved;
    roster->entries[roster->count].change = change;
    roster->entries[roster->count++].client = client;
    return client;
}

bool roster_draw(Client *client, const Request *request, Image *image, Reply *reply) {
    DrawResult result = client_draw(client, request, image, reply);
    return result == DRAW_OK || result == DRAW_FAILED ||
           check_fail("our own lab in %s could not draw: %s", client->folder, reply->message);
}

void roster_destroy(Roster *roster) {
    for (int i = 0; i < roster->count; i++) {
        client_stop(roster->entries[i].client);
        free(roster->entries[i].client);
    }
    roster->count = 0;
}
