// When a mistake of the catalogue may be named.
#pragma once

#include "diagnose/reset.h"

#include <stdbool.h>

// Of the failed checks' pictures: where they show so little, many causes draw that.
typedef enum NamedLooks {
    NAMED_SHOWN,
    NAMED_PLAIN,    // one colour each
    NAMED_NO_EDGES, // no edge of a shadow is left in any
    NAMED_NO_EFFECT // those of the mistake's task are the lab without it
} NamedLooks;

typedef struct Named {
    int first, second; // numbers in rubric->mistakes; second draws nearly the same; -1: none
    bool many;         // a third one draws nearly the same, and their tasks are not all the same
    NamedLooks looks;
} Named;

// The mistake whose pictures are much nearer than the reference in every check of `failed` that shows
// anything, and with which no check fails that passed here. It must lie in a part of the fault, if one was
// found, or in one of `found` (NULL: none were looked for) that can have it. Where no check shows anything,
// only a mistake in such a part is named, as one of several. False with a message when ours cannot draw.
bool catalogue_find(Named *named, const LabResult *result, Exam *exam, const bool failed[],
                    const ResetFound *found);
