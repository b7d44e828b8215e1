// The few colours of all scenes, chosen to be looked at for long: what receives shadows is pale, what throws
// them is clear, and any two are told apart.
#pragma once

#include "scene/scene.h"

// A colour that a scene draws for an object (part_color) has channels of at least this. One whose channels
// all are lower is the scene's own.
#define PALETTE_DARKEST 0.35f

// Gives each object a colour of the palette: the largest planes one of the pale ones, everything else one of
// the clear ones. Which one, and how bright, is drawn from `random`, so that no colour can be known before.
// Objects that had one colour get one again, and a scene's own colours stay.
void palette_vary(Scene *scene, Random *random);

// The same without chance, for pictures: the colours in their order, own ones, too, and the palette's
// background.
void palette_apply(Scene *scene);
