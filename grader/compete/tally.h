// What a lab's frames in all cameras of an arena cost, and how far they are from the truth.
#pragma once

#include "compete/arena.h"
#include "exam/worker_client.h"

#include <stdbool.h>

typedef struct ArenaTally {
    double taps, fragments, texels; // means over the cameras, a pixel of the picture
    double error;                   // the same, over the pixels that count, 0..1
    double dark, true_dark;         // the same, of what is missing to white in the frames and in the truths
} ArenaTally;

// Draws setting number `setting` in all cameras, counted in this way (COUNTED_...): the client's worker must
// not have drawn otherwise. False with a message for whose lab it is, who may also have drawn past the
// counters.
bool tally_take(ArenaTally *tally, const Arena *arena, int setting, WorkerClient *client, int counted);
