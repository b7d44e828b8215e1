// Names of people as keys: without case, accents and marks, so that "Lée, Ann" is "Ann Lee".
#pragma once

enum { NAME_KEY = 200 };

// The words of the name in alphabetical order, with a space between. Letters with accents of the Latin
// alphabets (U+00C0 to U+017F, or composed of two characters) are their base letters; letters of other
// alphabets stay.
void name_key_words(char key[NAME_KEY], const char *name);

// The letters and digits alone, as they come: of "Lee" and "Ann" "leeann".
void name_key_joined(char key[NAME_KEY], const char *first, const char *second);
