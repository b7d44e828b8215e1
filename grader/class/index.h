// The page of a class.
#pragma once

#include "class/table.h"

// Distribution of the scores, the commonest mistakes, who needs a look, and all submissions with links to
// their pages. The caller frees the page; NULL with a message.
char *index_page(const Table *table);
