// Scores a frame by its pixels and by what it tells beside them.
#pragma once

#include "exam/exam.h"
#include "score/score.h"

// Does a stage have another size than that of ours? A lab without the stage has none, which its picture
// tells.
bool frame_wrong_size(const FrameFacts *yours, const FrameFacts *ours);

// `ours` is the variant's reference, or another picture that is right. Without a frame (no pixels), or with a
// stage of another size, the error is 1; where GL refused a call only a part of the points is given.
FrameScore frame_score(const Image *yours, const FrameFacts *facts, const Variant *variant,
                       const Image *ours);
