// Which context draws where nobody asks for one: the one place that chooses.
#pragma once

#include "scene/context_kind.h"

// Settles CONTEXT_ANY: what the environment asks for by SHADOW_LAB_CONTEXT; else OSMesa where it is
// installed, else EGL. Another kind stays. False with a message when the environment asks for none of them.
bool context_choose(ContextKind *kind);

// The same for a program that draws, before it begins: where it is EGL for want of OSMesa, that is said on
// standard error after the program's name.
bool context_choose_aloud(ContextKind *kind, const char *program);
