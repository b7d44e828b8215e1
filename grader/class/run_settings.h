// What a class run grades by, fixed when it begins: OUT/class.json.
#pragma once

#include "class/class_settings.h"
#include "grade/session.h"

#include <stdbool.h>

typedef struct RunSettings {
    uint64_t seed;
    ContextKind context;
    double seconds;
    bool no_swap;
    int lab_count; // never 0
    char labs[COURSE_MAX_LABS][3];
    int lock; // descriptor of class.json, which holds the lock; -1: none
} RunSettings;

// Reads OUT/class.json, or makes it of the settings when it is not there yet; of several that begin at once,
// all get the same. Takes a lock on OUT: a run of the whole class must be alone, runs with --only may be
// many. False with a message: another run is at work, a run is there already, or the settings want something
// else than it. A dry run makes and locks nothing.
bool run_settings_open(RunSettings *plan, const ClassSettings *settings);
void run_settings_close(RunSettings *plan);

// Makes a session of the plan's labs, in this jail. False with a message.
bool run_settings_session(const RunSettings *plan, const Jail *jail, Session *session);
