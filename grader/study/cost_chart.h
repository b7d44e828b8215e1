// Error against counted cost: an axis that all machines share.
#pragma once

#include "study/finding.h"

// Charts the labs' settings, without rays, by their counted cost a pixel: folder/SCENE-cost.svg. False with a
// message.
bool cost_chart(const SceneFindings *findings, const char *folder);
