// A scene's findings as a picture for documents: log time against log error, readable on a telephone.
#pragma once

#include "study/finding.h"

// Writes folder/SCENE.svg. False with a message.
bool chart_draw(const SceneFindings *findings, const char *folder);
