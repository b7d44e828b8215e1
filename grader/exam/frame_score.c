#include "exam/frame_score.h"

// What a frame in which GL refused a call gets of its points: it may be drawn otherwise by another driver.
static const double REFUSED_SHARE = 0.5;

bool frame_wrong_size(const FrameFacts *yours, const FrameFacts *ours) {
    return yours->stage_width > 0 &&
           (yours->stage_width != ours->stage_width || yours->stage_height != ours->stage_height);
}

FrameScore frame_score(const Image *yours, const FrameFacts *facts, const Variant *variant,
                       const Image *ours) {
    if (!yours->rgba || frame_wrong_size(facts, &variant->facts))
        return (FrameScore){.inside = 1};
    FrameScore score = score_frame(yours, ours, &variant->without, &variant->skeleton);
    if (facts->refused)
        score.share *= REFUSED_SHARE;
    return score;
}
