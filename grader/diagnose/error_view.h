// The words that fit a check.
#pragma once

#include "compile/rubric.h"
#include "score/error_kind.h"

// What the check's view can show. The labs before the first shadow map have no shadows; stages are maps,
// atlases and counts.
ErrorView error_view_of(const Check *check, const Rubric *rubric);
