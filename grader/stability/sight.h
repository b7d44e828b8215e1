// Where the shadow volumes of a scene's boxes lie along a pixel's ray: closed forms for what z-pass and
// z-fail count. A caster and its shadow are one convex set. Z-pass counts the sets that hold the visible
// point less those that hold the ray's point on the near plane, z-fail less those that hold its point on the
// far plane: the methods fail where that point is in a set.
#pragma once

#include "stability/probe.h"

// The scene without its planes, which are open and cast no volumes.
Scene sight_casters(const Scene *scene);

// From the eye through the middle of a pixel (row 0 is the top row), as long as one unit of depth.
vec3s sight_ray(const Camera *camera, MetricsSize size, int column, int row);

// Does this point lie in a caster's set, as light 0 sees it? For the set of one caster keep only that in
// `casters`.
bool sight_holds(const Scene *casters, vec3s point);

// The same for the ray's point at a depth from the eye, which may be INFINITY.
bool sight_holds_at(const Scene *casters, vec3s ray, double depth);

// How often the way between two points enters a caster's set, looked at in `steps` places.
int sight_enters(const Scene *casters, vec3s from, vec3s to, int steps);

// A share of the pixels that count in the probe's latest frame. OpenGL keeps the corners of a triangle to
// 1/16 of a pixel at least (GL_SUBPIXEL_BITS is 4 or more). So an outline, of the true shadow or of the
// share, may pass the middle of one of the two pixels that it separates where it lies as near to it as that:
// `tolerance` is 2/16 for each pair of such pixels.
typedef struct SightShare {
    double share, tolerance;
} SightShare;

// The share for which `flags`, one a pixel, is not 0. NULL: the share 0, of which just shadows have outlines.
SightShare sight_share(const Probe *probe, const uint8_t *flags);

// The share whose ray's point at this depth is in a set. False with a message when there is no memory.
bool sight_share_at(const Probe *probe, double depth, SightShare *share);
