// What a worker says of its lab, made safe to show and to calculate with.
#pragma once

#include "protocol/protocol.h"

// Ends texts and replaces what is not printable ASCII by '?', limits counts to the arrays, gives a knob
// without a finite, ordered range the range 0..0, and puts the default into the range.
void description_clean(Description *description);

// Ends the text of `size` bytes and replaces what is not printable ASCII by '?'.
void description_clean_text(char *text, size_t size);

// Makes whole numbers from 0 on of what was counted, and text of printable ASCII.
void description_clean_counts(FrameCounts *counts);

// Has the lab all knobs of the request, and are the values in their ranges, and whole where a knob chooses?
// False with a message.
bool description_fits(const Description *description, const Request *request);
