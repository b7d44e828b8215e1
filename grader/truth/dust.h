// What the dust between the eye and what it sees sends to the eye.
//
// A triangle keeps the light from a piece of space with flat sides, so from one segment of each ray from the
// eye. The union of these segments, and for a spot light what lies behind it, is dark; the rest of the way to
// the point, or to the camera's far plane, is lit. Each lit segment from t0 to t1 sends scattering * (e^(-e
// t0) - e^(-e t1)) / e, with e the extinction. All in double precision, without samples.
#pragma once

#include "truth/truth.h"

// Fills `scattered`, one value a pixel of the picture, the background too: the sum over the lit segments, in
// units of the light's colour, without the factor 1/4 of a phase function. Light `light` counts as a point,
// whatever its extent. At least 0; at most scattering / extinction.
void dust_trace(const Truth *truth, const TruthPicture *picture, int light, float *scattered);
