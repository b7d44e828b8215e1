// Reading is getopt_long's; what it leaves open is here: the names of what is wrong, values that are
// forgotten, operands.
#include "base/command_line.h"

#include "base/command_help.h"
#include "base/context_choice.h"
#include "base/printable.h"
#include "scene/check.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_OPTIONS = 40, FIRST = 256, HELP = FIRST + MOST_OPTIONS };

// The table in the form that getopt_long reads. An option is known by FIRST plus its place.
typedef struct Engine {
    struct option names[MOST_OPTIONS + 2];
    char letters[2 * MOST_OPTIONS + 4];
} Engine;

static bool is_end(const Option *option) {
    return !option->name && !option->letter && !option->help;
}

static void fill(Engine *engine, const Option *options) {
    int used = 0;
    *engine = (Engine){.letters = ":h"}; // ":": a missing value is told from an unknown option
    for (int i = 0; !is_end(&options[i]); i++) {
        const Option *option = &options[i];
        INVARIANT(i < MOST_OPTIONS);
        const int argument = option->value ? required_argument : no_argument;
        if (option->name)
            engine->names[used++] = (struct option){option->name, argument, NULL, FIRST + i};
        if (option->letter)
            check_append(engine->letters, sizeof engine->letters, "%c%s", option->letter,
                         option->value ? ":" : "");
    }
    engine->names[used] = (struct option){"help", no_argument, NULL, HELP};
}

// The option that getopt_long means; NULL when there is none.
static const Option *find(const Option *options, int code) {
    if (code >= FIRST && code < HELP)
        return &options[code - FIRST];
    for (int i = 0; !is_end(&options[i]); i++)
        if (options[i].letter && options[i].letter == code)
            return &options[i];
    return NULL;
}

static void name_of(char *text, size_t size, const Option *option) {
    if (option->name)
        snprintf(text, size, "--%s", option->name);
    else
        snprintf(text, size, "-%c", option->letter);
}

// The names that begin with the first `length` bytes of `begin`; their number.
static int list_candidates(char *text, size_t size, const Engine *engine, const char *begin, size_t length) {
    int found = 0;
    text[0] = '\0';
    for (const struct option *name = engine->names; length > 0 && name->name; name++)
        if (strncmp(name->name, begin, length) == 0)
            check_append(text, size, "%s--%s", found++ ? ", " : "", name->name);
    return found;
}

static bool refuse_name(const Engine *engine, const char *argument) {
    char names[400];
    const size_t length = strcspn(argument, "=");
    char *begin = strndup(argument, length), *shown = begin ? printable_name(begin) : NULL;
    INVARIANT(shown);
    if (list_candidates(names, sizeof names, engine, begin + 2, length - 2) > 1)
        check_fail("%.200s: which one? %s", shown, names);
    else
        check_fail("%.200s: unknown option; --help lists them", shown);
    free(begin);
    free(shown);
    return false;
}

// What getopt_long answers with '?': no such option, several, or a value for one that takes none.
static bool refuse(const Engine *engine, const Option *options, char **arguments) {
    if (optopt == 0)
        return refuse_name(engine, arguments[optind - 1]);
    const Option *option = optopt >= FIRST ? find(options, optopt) : NULL;
    if (option || optopt == HELP)
        return check_fail("--%s takes no value", option ? option->name : "help");
    const char letter[] = {(char)optopt, '\0'};
    char *shown = printable_name(letter);
    INVARIANT(shown);
    check_fail("-%s: unknown option; --help lists them", shown);
    free(shown);
    return false;
}

static bool refuse_missing(const Option *option) {
    char name[64];
    name_of(name, sizeof name, option);
    return check_fail("%s needs a value: %s", name, option->value);
}

// Who forgets a value before another option does not mean that option as the value. `=` gives such a value
// all the same.
static bool is_forgotten(const char *value, const char *argument) {
    return value[0] == '\0' || (value == argument && strncmp(value, "--", 2) == 0);
}

static bool take(const Option *option, void *settings, const char *value, const char *argument) {
    char name[64], message[1000];
    if (option->value && is_forgotten(value, argument))
        return refuse_missing(option);
    if (option->take((char *)settings + option->target, value))
        return true;
    snprintf(message, sizeof message, "%s", check_message());
    check_clear();
    name_of(name, sizeof name, option);
    return check_fail("%s %s", name, message);
}

static bool check_count(const CommandLine *line, const Operands *operands) {
    if (operands->count < line->least)
        return check_fail("%s is missing", line->operand);
    for (int i = 0; i < operands->count; i++) {
        char *shown = printable_name(operands->texts[i]);
        INVARIANT(shown);
        if (i >= line->most)
            check_fail(line->operand ? "\"%.200s\" is one operand too many" : "\"%.200s\" is not an option",
                       shown);
        else if (!operands->texts[i][0])
            check_fail("\"\" is no %s", line->operand);
        free(shown);
    }
    return check_message()[0] == '\0';
}

CommandLineResult command_line_read(const CommandLine *line, void *settings, int count, char **arguments) {
    Engine engine;
    fill(&engine, line->options);
    opterr = 0;
    optind = 0; // from the beginning, whoever has used it before
    for (int code; (code = getopt_long(count, arguments, engine.letters, engine.names, NULL)) != -1;) {
        if (code == HELP || (code == 'h' && !find(line->options, 'h')))
            return COMMAND_LINE_HELP;
        const bool ok = code == '?' ? refuse(&engine, line->options, arguments)
                        : code == ':'
                            ? refuse_missing(find(line->options, optopt))
                            : take(find(line->options, code), settings, optarg, arguments[optind - 1]);
        if (!ok)
            return COMMAND_LINE_WRONG;
    }
    const Operands operands = {arguments + optind, count - optind};
    const bool ok = check_count(line, &operands) && (!line->check || line->check(settings, &operands));
    return ok ? COMMAND_LINE_READ : COMMAND_LINE_WRONG;
}

void command_line_complain(const CommandLine *line, const char *message) {
    fprintf(stderr, "%s: %s\n", line->program, message);
    command_help_forms(line, stderr);
}

void command_line_take(const CommandLine *line, void *settings, int count, char **arguments) {
    switch (command_line_read(line, settings, count, arguments)) {
    case COMMAND_LINE_READ:
        return;
    case COMMAND_LINE_HELP:
        command_help_print(line, stdout);
        if (fflush(stdout) == 0 && !ferror(stdout))
            exit(0);
        fprintf(stderr, "%s: the help cannot be written\n", line->program);
        exit(1);
    case COMMAND_LINE_WRONG:
        command_line_complain(line, check_message());
        exit(EXIT_USAGE);
    }
}

void command_line_settle_context(const CommandLine *line, ContextKind *kind) {
    if (context_choose_aloud(kind, line->program))
        return;
    command_line_complain(line, check_message());
    exit(EXIT_USAGE);
}
