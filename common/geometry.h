// What the camera sees in every pixel, its normal and distance, for passes that work on the picture alone.
// The shaders' side is shaders/geometry.frag and shaders/view_space.glsl.
#pragma once

#include "draw.h"
#include "target.h"

// A target of the frame's size for geometry_draw.
bool geometry_create(Target *geometry, const Frame *frame);

// Draws the scene into `geometry` with a program of scene.vert and geometry.frag.
void geometry_draw(const Target *geometry, const Frame *frame, const Program *program);

// Sets the uniforms of shaders/view_space.glsl in a program that includes it.
void geometry_use(const Target *geometry, const Frame *frame, const Program *program);
