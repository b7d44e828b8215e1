// One hand-in in the contest: it is graded, and who passes is drawn, counted and held against the truth.
#pragma once

#include "compete/arena.h"
#include "compete/standing.h"
#include "grade/session.h"

// Fills all of the standing but its name and place. The session grades the arena's lab alone. What a hand-in
// does wrong is a reason in the standing; false with a message is a fault of ours.
bool entrant_run(Standing *standing, const Arena *arena, Session *session, const char *path);
