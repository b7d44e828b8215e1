// What a lab is given of the labs before it (common/GIVEN), placed beside its files: "given" in its folder.
#pragma once

#include "jail/jail.h"

#include <stdbool.h>

// Places it in `folder`, where it is not yet, for the lab "03"; "all": everything. For the jail it is a copy,
// outside a link. False with a message.
bool given_place(const char *folder, const char *id, const Jail *jail);
