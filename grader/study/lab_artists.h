// Who draws a study's methods: one artist for each lab and each change of it, and the same of the submission.
#pragma once

#include "study/method.h"

enum { CREW_MOST = 32 };

typedef struct Crew {
    const char *submission_lab, *submission; // NULL: there is none
    const Jail *jail;                        // for the submission; NULL: none
    struct {
        Artist *artist;
        const char *lab;
        const Change *change;
        bool submission;
    } members[CREW_MOST]; // hired when they are first asked for
    int count;
} Crew;

// The artist of a method; NULL with a message when its lab or the submission cannot be built.
Artist *crew_get(Crew *crew, const Method *method);

// A name for what this artist draws with, made from its content.
uint64_t crew_key(const Artist *artist);

void crew_dismiss(Crew *crew); // accepts a zeroed crew
