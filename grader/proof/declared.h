// The variables, parameters and fields that a source declares, as far as its words tell.
#pragma once

#include "proof/source.h"

#include <stdbool.h>

enum { DECLARED_MAX = 200 };

typedef struct Declared {
    int type, name; // pieces
    int stars;      // of a pointer
    bool field;     // of a struct
    int begin, end; // pieces between which it is known
} Declared;

typedef struct Declarations {
    Declared list[DECLARED_MAX];
    int count;
} Declarations;

// Finds at most DECLARED_MAX of them; the rest is as if it were not declared.
void declared_find(Declarations *declarations, const Source *source);

// What piece i names; NULL when that is not declared here.
const Declared *declared_at(const Declarations *declarations, const Source *source, int i);

// May one stand in the place of the other at piece i: is it another one of the same type, known there?
bool declared_may_stand(const Source *source, const Declared *other, const Declared *one, int i);
