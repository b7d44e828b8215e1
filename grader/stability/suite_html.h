// The suite's page.
#pragma once

#include "stability/row.h"

// One self-contained page with each row's words, curves, numbers and worst frames. The figures were drawn
// into `folder` by plot_all. The caller frees the text; NULL with a message.
char *suite_html(const RowResult *results, int count, const char *folder);
