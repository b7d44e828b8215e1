// The command line of every program: one constant table says which options there are, and parsing, --help and
// all refusals come from it. Of an option that is given twice the last one counts, unless its help says that
// it may be repeated.
#pragma once

#include "base/option_table.h"
#include "scene/context_kind.h"

// What all programs end with when the command line makes no sense.
enum { EXIT_USAGE = 2 };

typedef enum CommandLineResult { COMMAND_LINE_READ, COMMAND_LINE_HELP, COMMAND_LINE_WRONG } CommandLineResult;

// Reads the arguments of main into `settings`, which hold the defaults. COMMAND_LINE_HELP as soon as --help
// (or -h) is met; COMMAND_LINE_WRONG with a message that names what is wrong. Reorders the arguments:
// operands go last.
CommandLineResult command_line_read(const CommandLine *line, void *settings, int count, char **arguments);

// The same for main: returns only when there is something to do. Otherwise ends the program, with the help on
// standard output and status 0, or with the message on standard error and status 2.
void command_line_take(const CommandLine *line, void *settings, int count, char **arguments);

// For a program that draws, before it begins: settles CONTEXT_ANY by context_choose_aloud. Ends the program
// with a message and status 2 when the environment asks for what there is not.
void command_line_settle_context(const CommandLine *line, ContextKind *kind);

// Prints what is wrong, and the program's forms, to standard error.
void command_line_complain(const CommandLine *line, const char *message);
