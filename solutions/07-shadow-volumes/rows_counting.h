// A curve of this lab: which pixels does a way of counting volumes get wrong?
#pragma once

#include "stability/row.h"
#include "stability/sight.h"

enum { COUNTING_SIZE = 160 };        // pixels each way
enum { Z_PASS, Z_FAIL, Z_FAIL_CPU }; // the last: with the volumes' sides found on the CPU

typedef struct Counting {
    LabSet *labs;
    Findings *findings;
    Curve *curve;
    const Change *change; // NULL: the solution as it is
    int method;
    int slot; // for the worst frame of the curve
} Counting;

// Traces the scene and draws its visibility. False with a message; the caller ends the probe in any case.
bool counting_begin(Probe *probe, const Counting *counting, const Scene *scene);

// Keeps the frame when it is the worst of the curve.
void counting_frame(const Counting *counting, const Probe *probe, double x, double badness);

// Adds the share of wrong pixels, which must be `expected`, and the frame. `fragile`: the share that another
// method gets wrong here; where this one is always right, the frame with most of that is kept.
void counting_add(const Counting *counting, const Probe *probe, double x, SightShare expected,
                  double fragile);
