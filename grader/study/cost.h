// What a setting costs on any machine.
#pragma once

#include "study/finding.h"

// From the setting and the scene. `partial` is the share of the picture's pixels that are neither wholly lit
// nor wholly dark: with early-out exactly these take all taps.
Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, double partial);
