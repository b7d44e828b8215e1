// The page of a class.
#pragma once

#include "book/book.h"

// Labs with their means, students and tasks at a glance, the hardest tasks, the commonest mistakes, who needs
// a look, and all students with links to their pages. `names`, one a row of the book, stand in the place of
// the students' (NULL: nobody is hidden). The caller frees the page; NULL with a message.
char *class_page(const Book *book, char *const *names);
