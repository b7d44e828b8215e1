// What comes out for one hand-in, and the order of all.
#pragma once

#include <stdbool.h>

enum { STANDING_NAME = 256, STANDING_REASON = 400, STANDING_NOTE = 128 };

// Counts are means over the cameras, a pixel of the picture.
typedef struct Standing {
    char name[STANDING_NAME];
    bool ranked;                  // else `reason` says why not
    char reason[STANDING_REASON]; // one line of text
    int place;                    // from 1 on; equal costs share one
    double cost;                  // taps + fragments + texels, rounded to a tenth: two machines round alike
    double taps, fragments, texels, error;
    char setting[64];
    char note[STANDING_NOTE]; // what somebody must look at (second_count.h); "" for nothing
} Standing;

// Fills the cost from what was counted.
void standing_cost(Standing *standing);

// Sorts by cost, then by name; whoever is not ranked comes last. Fills the places.
void standing_sort(Standing *standings, int count);
