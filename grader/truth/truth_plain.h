// The plain way to trace, that the packets of truth_trace are measured against.
#pragma once

#include "truth/truth.h"

// As truth_trace, but each pixel for itself: row by row, with samples of its own, and every ray given to
// Embree alone, without a word about its neighbours. Single queries of lights give the same visibility; for
// areas and occlusion the samples are others. The query must be one that truth_trace takes.
void truth_trace_plainly(const Truth *truth, const TruthPicture *picture, const TruthQuery *query,
                         float *visibility);
