// Everything of ours that draws for one lab: the solution, the skeleton, the solution without one task, with one
// mistake. Each is built and started when it is first asked for.
#pragma once

#include "client.h"
#include "rubric.h"

#include <stdbool.h>

enum { ROSTER_MAX = 64 };

typedef struct Roster {
    const Rubric *rubric;
    ContextKind context;
    struct {
        Solved solved;
        const Change *change; // NULL: none
        Client *client;
    } entries[ROSTER_MAX];
    int count;
} Roster;

// The worker of the lab with these tasks solved and this change. NULL with a message when it cannot be made.
Client *roster_get(Roster *roster, Solved solved, const Change *change);

// Draws with one of ours. False when it does not even start or is lost: a fault of ours. A lab that says why it drew
// nothing counts as black.
bool roster_draw(Client *client, const Request *request, Image *image, Reply *reply);

void roster_destroy(Roster *roster); // accepts a zeroed roster
