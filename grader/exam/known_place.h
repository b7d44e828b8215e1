// The line of a lab's source that a worker's reply tells by a number. It is asked for once: a lab says the
// same in many frames, and asking starts a process.
#pragma once

#include "compile/compiler.h"
#include "protocol/protocol.h"

typedef struct KnownPlace {
    char folder[FILES_PATH]; // of lab.so; "": none is known
    uint64_t offset;         // in lab.so
    char text[COMPILE_PLACE];
} KnownPlace;

// Appends " (lab.c:80)" to the message of a reply that tells a place in folder/lab.so, which must be the same
// file as when `known` was filled in (zeroed: nothing is known). Says nothing where no line is found.
void known_place_append(KnownPlace *known, const char *folder, const Jail *jail, Reply *reply);
