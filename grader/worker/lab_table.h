// A lab's table in the words of the protocol.
#pragma once

#include "protocol/protocol.h"

// Fills a zeroed description.
void lab_table_describe(const Lab *lab, Description *description);
