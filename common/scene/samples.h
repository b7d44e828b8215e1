// Pairs of numbers that cover the unit square evenly, the same on every machine. No GL.
#pragma once

#include "scene/mathx.h"

#include <stdint.h>

// The i-th of `count` pairs in [0, 1) x [0, 1): Hammersley's points, shifted as a whole (and wrapped around)
// by a random amount that `seed` decides, so that neighbours with other seeds see other points. Cranley,
// Patterson: Randomization of Number Theoretic Methods for Multiple Integration, SIAM J. Numer. Anal. 1976.
vec2s sample_pair(uint64_t seed, int i, int count);
