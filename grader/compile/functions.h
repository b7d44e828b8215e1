// Takes a file of C or GLSL apart into its functions and the rest, and puts it together again with some parts
// of another version of the file. No compiler: what it cannot take apart it says so. No files.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { FUNCTIONS_MAX = 64, FUNCTIONS_NAME = 64 };

// One definition: text[begin] is the first character of its type, text[end - 1] its last brace.
typedef struct Function {
    char name[FUNCTIONS_NAME];
    size_t begin, end;
    int branch; // of #if and #else around it; 0: none
} Function;

typedef struct Functions {
    const char *text; // not owned
    Function list[FUNCTIONS_MAX];
    int count;
    bool whole; // the text cannot be taken apart: braces do not match, or #if cuts a function in two
} Functions;

// Finds the functions of `text`, which must outlive the result.
void functions_split(Functions *functions, const char *text);

// The first definition of this name; NULL when there is none.
const Function *functions_find(const Functions *functions, const char *name);

// Is every definition of this name, and their number, the same in both but for blanks and comments?
bool functions_same(const Functions *a, const Functions *b, const char *name);

// Is the text outside of functions the same but for blanks and comments?
bool functions_same_outside(const Functions *a, const Functions *b);

// Is `name` in b written with the same types as `other` in a? Then it may be that function under another
// name.
bool functions_same_signature(const Functions *a, const char *other, const Functions *b, const char *name);

// What is taken from ours: functions by name, and the text outside of functions.
typedef struct Choice {
    const char *names[FUNCTIONS_MAX];
    const char *called[FUNCTIONS_MAX]; // what theirs calls it; NULL: the same
    int count;
    bool outside;
} Choice;

// Is our function of this name chosen?
bool choice_has(const Choice *choice, const char *name);

// Their text with the chosen parts of ours, and with those of our functions which the chosen ones call and
// theirs lacks. Freed by the caller.
char *functions_compose(const Functions *theirs, const Functions *ours, const Choice *choice);
