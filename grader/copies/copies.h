// Which hand-ins of a class have the same code: pairs for people to look at.
#pragma once

#include "class/class_settings.h"
#include "class/table.h"

// Reads all hand-ins again (archives in the jail), takes away what was handed out in labs/, and writes
// OUT/copies.csv: of each lab the pairs that share half of what is their own, or all. What more than four
// students and a tenth of the class have is no sign of anything and does not count. `count` gets the number
// of pairs. False with a message.
bool copies_write(const Table *table, const ClassSettings *settings, int *count);
