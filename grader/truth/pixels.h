// The truth of whole pixels: the mean over a pixel's area, which is what a person sees. The truth at its
// centre (truth_trace) is the best that one sample a pixel can do, and takes filters for errors.
#pragma once

#include "truth/truth.h"

// dot(normal, direction to the light) by which a pixel counts for this query (truth_facing); 1 for occlusion
// and dust, which have no direction; -1 for the background.
float pixels_facing(const Scene *scene, const TruthQuery *query, const TruthHit *hit);

// Visibility of each pixel of `centers` (as truth_look fills it) by across x across rays from the camera, one
// in each stratum of the pixel, and from where they arrive: one ray to a light without a size, else a share
// of query->samples, so that a pixel has so many in all. Rays that meet another object than the pixel's
// centre or a face that is turned away from the light do not count, for there nothing is compared. `across`
// is a power of two, its square divides query->samples. False with a message when there is no memory or the
// query is wrong.
bool pixels_trace(const Truth *truth, const TruthPicture *centers, const TruthQuery *query, int across,
                  float *visibility);

// The mean of two such traces of different seeds; `noise` is what the first has more than it. That is in the
// mean as far as the mean itself is from what is true.
bool pixels_trace_twice(const Truth *truth, const TruthPicture *centers, const TruthQuery *query, int across,
                        float *visibility, float *noise);
