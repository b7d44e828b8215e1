// The edge of a shadow in pixels: how long it is, by how much a method misses it, and how large a texel of
// the map is there.
#pragma once

#include "study/truth_view.h"

// Length in pixels of the line at which the true visibility crosses 1/2, inside one object and where the mask
// is 1 on all sides: marching squares with linear interpolation (Lorensen, Cline: Marching Cubes, SIGGRAPH
// 1987) through the smoothed truth. Of a truth of whole pixels, straight edges are right to 0.1 % at every
// angle; of one sample a pixel, up to 2 % too long.
double edge_length(MetricsSize size, const int32_t *traced, const uint8_t *mask, const float *truth);

// Mean distance in pixels by which the edge is off: the wrong area in the edge zone per length of the edge. 0
// where there is no edge.
double edge_error(const Metrics *metrics, double length);

// How many pixels the side of light 0's map is long where the edge lies, in the direction in which it is
// longest; 95 % of the edge's pixels have less. A texel is that, divided by the texels of a side. 0 where
// there is no edge.
double edge_map_side(const TruthView *truth_view);
