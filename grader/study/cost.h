// What a setting costs on any machine.
#pragma once

#include "study/finding.h"

// From what was counted of a frame (counted_frame.h), and what the setting says of its bake and its memory.
Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, const MeasuredErrors *counted);
