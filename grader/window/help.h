// The table of keys, in as many pages as the window needs.
#pragma once

#include "window/lines.h"

// Adds a page, from 1, of the table to empty lines whose columns are set; `rows` of them have room. How many
// pages there are: 1 where all fits.
int help_page(Lines *lines, int rows, int page);

// Puts a page into the middle of a window of this size in pixels; the last one where there are fewer.
void help_put(Text *text, int width, int height, int page);

// How many there are.
int help_pages(const Text *text, int width, int height);
