// Which exam a hand-in meets. A round is a list of hand-ins that were all there before anything was drawn for
// it, so that none of them can hold what came back of its exam: they all meet that one. What comes later, or
// is changed, is in a later round.
//
// The exam is made from the list and the class's secret seed. So another list is another exam, also where
// somebody begins anew with the same seed.
#pragma once

#include "class/roster.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct HandInRound {
    uint64_t seed;
    uint64_t *marks; // of its hand-ins (hand_in_mark), rising
    int count;
} HandInRound;

typedef struct Rounds {
    const char *output; // OUT: its rounds lie in OUT/rounds/, "1" and so on
    const Roster *roster;
    uint64_t secret;
    HandInRound *list;
    int count;
} Rounds;

// What a hand-in meets.
typedef struct Meeting {
    bool alone; // it holds more than can be looked at: it needs an exam of its own
    int round;  // from 0
    uint64_t seed, mark;
} Meeting;

// Says which round this entry is in, as it is now. When it is in none, a new round begins, with all entries
// of the roster that are in none; of one student's several attempts with the first, and so on: no two of them
// meet one exam if they differ. The list is on the disk before this returns; of processes that begin one at
// the same time, all take the same. False with a message.
bool rounds_meet(Rounds *rounds, const RosterEntry *entry, Meeting *meeting);

// Is the entry still what it was when this was said? False with a message.
bool rounds_same(const Rounds *rounds, const RosterEntry *entry, const Meeting *meeting);

// Sorts numbers of entries by their rounds, so that an exam is drawn but once. False with a message.
bool rounds_sort(Rounds *rounds, int *numbers, int count);

void rounds_destroy(Rounds *rounds); // accepts a zeroed one
