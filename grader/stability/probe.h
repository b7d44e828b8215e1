// One scene that a lab draws again and again, each time held against the scene's truth under its light 0:
// what is lit, or with dust in the air what it sends to the eye.
#pragma once

#include "stability/lab_set.h"
#include "study/truth_view.h"

#include <stdbool.h>

typedef struct Probe {
    LabSet *labs;
    const char *lab;
    const Change *change; // NULL: the solution as it is
    Setting setting;      // the visibility of all objects
    TruthView truth_view;
    Measured measured; // of the latest frame
} Probe;

// Traces the scene; width x height pixels. False with a message; the caller ends the probe in any case.
bool probe_begin(Probe *probe, LabSet *labs, const char *lab, const Scene *scene, int width, int height);
void probe_end(Probe *probe); // accepts a zeroed probe

// Gives the knob a value, from now on.
void probe_knob(Probe *probe, const char *name, double value);

// Draws and measures. False with a message.
bool probe_draw(Probe *probe);

// World units of a wall (truth/closed_scenes.h) per pixel.
double probe_unit(const Probe *probe);

// Mean of false light (sign 1) or false shadow (-1) over the pixels that count, lie on `object`, are dark
// (lit) in truth and are no edge. NAN when there are none.
double probe_false(const Probe *probe, int object, int sign);
