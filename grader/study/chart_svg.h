// A scene's findings as a picture for documents: log time against log error, readable on a telephone.
#pragma once

#include "study/finding.h"

// Writes folder/SCENE.svg. False with a message.
bool chart_draw(const SceneFindings *findings, const char *folder);

// The place of a family in the list of the scene's families, in the order of their first setting.
int chart_family(const SceneFindings *findings, const char *family, bool submission);

// The color of a setting's family, "#rrggbb".
const char *chart_color(const SceneFindings *findings, const Method *method);
