// Notes what a student's own grading found in the progress (progress.h).
#pragma once

#include "diagnose/result.h"
#include "grade/session.h"

// Notes each lab that was drawn: what does not compile is no step back. `told`: says on standard output which
// labs are done now. What keeps it from being noted goes to standard error.
void record_report(const Report *report, const Session *session, bool told);
