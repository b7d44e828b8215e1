// Costs that are counted while a frame is drawn, in the place of those that cost.h works out.
#pragma once

#include "study/finding.h"
#include "study/lab_artists.h"

#include <stdbool.h>

// Counts a frame of each of the labs' settings, as the scene itself has it (worker/counted.h): reads and
// fragments become the finding's, and `counted` the sum of reads, fragments and cleared texels; rays and
// bytes stay. Charts error against that sum a pixel, without rays: folder/SCENE-cost.svg. False with a
// message when a lab does not draw so.
bool counted_costs(SceneFindings *findings, LabArtists *artists, const char *folder);
