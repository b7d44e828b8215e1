// Who draws a study's methods: one artist for each lab and each change of it, and the same of the submission.
#pragma once

#include "study/method.h"

#include <stdint.h>

enum { CREW_MOST = 64 };

typedef struct LabArtists {
    const char *submission_lab, *submission; // NULL: there is none
    const Jail *jail;                        // for the submission; NULL: none
    ContextKind context;
    uint32_t without; // as LabArtist has it
    struct {
        LabArtist *artist;
        const char *lab;
        const Change *change;
        bool submission;
    } members[CREW_MOST]; // hired when they are first asked for
    int count;
} LabArtists;

// The artist of a method; NULL with a message when its lab or the submission cannot be built.
LabArtist *lab_artists_get(LabArtists *artists, const Method *method);

// A name for what this artist draws with, made from its content.
uint64_t lab_artists_key(const LabArtist *artist);

void lab_artists_dismiss(LabArtists *artists); // accepts zeroed artists
