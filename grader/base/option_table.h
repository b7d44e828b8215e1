// What a program's command line is made of: one constant table, from which parsing, --help and all refusals
// come.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// An entry with `help` alone is a heading over those that follow it; the table ends with an entry of zeros.
typedef struct Option {
    const char *name;  // "lab" for --lab; NULL: it has only the letter
    char letter;       // 'j' for -j; 0: it has only the name
    const char *value; // the word for its value in the help, "NN"; NULL: it takes none
    const char *help;  // what it does; may have several lines
    size_t target;     // where its value goes: offsetof a field of the program's settings
    // Puts the value (NULL when it takes none) there; see option_values.h. Otherwise false with a message
    // that goes on after the option's name: "takes osmesa or egl, not \"glx\"".
    bool (*take)(void *target, const char *value);
} Option;

// What is no option, in order. Points into the program's arguments.
typedef struct Operands {
    char **texts;
    int count;
} Operands;

typedef struct CommandLine {
    const char *program; // "grade"
    const char *forms;   // what may follow build/grade, a form a line: "[options] SUBMISSION"
    const char *about;   // what the program does and what its operands are: whole lines
    const Option *options;
    const char *ending;  // whole lines for the end of the help; NULL: none
    const char *operand; // the word for an operand, "SUBMISSION"; NULL when it takes none
    int least, most;     // operands
    // Looks at all of it together, and takes the operands. False with a message. NULL: there is nothing to
    // look at.
    bool (*check)(void *settings, const Operands *operands);
} CommandLine;
