// A scene's findings as a picture for documents: log time against log error, readable on a telephone.
#pragma once

#include "study/finding.h"

typedef enum ChartAxis { CHART_TIME, CHART_COST } ChartAxis;

// Writes folder/SCENE.svg, or, of findings with costs in the place of times, folder/SCENE-cost.svg. False
// with a message.
bool chart_draw(const SceneFindings *findings, ChartAxis axis, const char *folder);
