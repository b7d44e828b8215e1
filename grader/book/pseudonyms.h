// Names in the place of the students', drawn at random and kept in a secret file: nobody can compute whose
// they are, and they stay the same from run to run.
#pragma once

#include "book/book.h"

// A pseudonym of each row of the book ("s-" and eight digits and letters), in the order of the rows. Those of
// the file (a CSV of students and pseudonyms; it need not be there yet) stay, and new ones are added to it;
// only its owner may read it. False with a message.
bool pseudonyms_make(char ***names, const Book *book, const char *file);

// The same of any students, known by these texts: of equal ones the names are equal.
bool pseudonyms_of(char ***names, const char *const *keys, int count, const char *file);
void pseudonyms_free(char **names); // accepts NULL
