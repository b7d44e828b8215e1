// The window's one line of where to look, which task, and why, as the watch and the report have it: the lab
// is graded beside the window, once when it opens and each time that newer files draw.
#pragma once

#include "watch/grading_process.h"
#include "window/app.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct ViewVerdict {
    GradingProcess grading;
    uint64_t described; // of FeedNews, when it was asked for last
    bool off;           // there is no rubric here, or nothing grades any more
} ViewVerdict;

// Asks for the verdict of what `app` shows, when there is text to see and newer files have drawn; takes what
// has come, and writes it into app->verdict ("=> ..."). To be called often; never waits. True when
// app->verdict is new.
bool view_verdict_tick(ViewVerdict *verdict, App *app);

void view_verdict_stop(ViewVerdict *verdict); // accepts a zeroed verdict
