// The number of elements of an array. Not in lab.h: a student may have a COUNT of his own.
#pragma once

// Of an array itself; of a pointer to its first element it would be wrong (gcc warns: -Wsizeof-pointer-div).
#define COUNT(array) (sizeof(array) / sizeof(array)[0])
