// The class without names: OUT/anonymous/.
#pragma once

#include "book/book.h"

// Writes index.html, grades.csv and pages/ there, all under the pseudonyms of `file` (pseudonyms.h) and in
// their order, without notes; the pages without points when `no_points`. False with a message.
bool anonymous_write(const Book *book, const char *output, const char *file, bool no_points);
