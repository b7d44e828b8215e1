#include "class/grade_options.h"

#include "scene/check.h"
#include "base/places.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const char options_usage[] =
    "usage: build/grade [options] SUBMISSION\n"
    "       build/grade [options] --class DIR --output OUT\n"
    "  SUBMISSION        a folder shaped like labs/, or the folder of one lab\n"
    "  --lab NN          only this lab; may be repeated\n"
    "  --seed N          the variants of an earlier run (default: drawn at random)\n"
    "  --context C       osmesa (default) or egl; also SHADOW_LAB_CONTEXT\n"
    "  --format F        text (default), json, html, gradescope or check50\n"
    "  --output DIR      pictures of what failed: yours, reference, difference\n"
    "  --record          note the points in the progress (see progress.h)\n"
    "  --timeout S       seconds that a submission may run per lab (default 20)\n"
    "  --jail ROUTE      bwrap or landlock: only this jail (default: the first that holds)\n"
    "  --trusted         no jail: the submission is my own work\n"
    "  --no-swap         do not look for the fault by putting our functions into the submission\n"
    "of a whole class, one submission a folder or archive (.zip, .tar.gz) in DIR:\n"
    "  --output OUT      a folder for grades.csv, index.html, pages/ and results/\n"
    "  -j N              submissions at a time (default: one a processor)\n"
    "  --resume          go on with the run in OUT; what is graded stays\n"
    "  --only NAME       grade only this one (again) and gather nothing; may be repeated\n"
    "  --gather          grade nothing; make grades.csv and index.html from the results\n"
    "  --list            print the names of the results, one a line\n"
    "exit status: 0 all passed (of a class: all graded), 1 not all passed, 2 usage, 3 could not grade\n";

static bool parse_seed(Options *options, const char *text) {
    char *end;
    errno = 0;
    options->grade.seed = strtoull(text, &end, 10);
    options->seeded = isdigit((unsigned char)text[0]) && *end == '\0' && errno == 0;
    return options->seeded || check_fail("--seed takes a whole number from 0 to 2^64 - 1, not \"%s\"", text);
}

static bool parse_timeout(Options *options, const char *text) {
    char *end;
    options->timed = true;
    options->grade.seconds = strtod(text, &end);
    return (*end == '\0' && options->grade.seconds > 0 && options->grade.seconds <= 3600) ||
           check_fail("--timeout takes seconds above 0 and at most 3600, not \"%s\"", text);
}

static bool parse_lab(Options *options, const char *id) {
    char folder[FILES_PATH];
    if (strlen(id) != 2 || !places_find_lab(folder, id)) {
        check_clear();
        return check_fail("there is no lab \"%s\"; give two digits as in solutions/, for instance --lab 02",
                          id);
    }
    for (int i = 0; i < options->lab_count; i++)
        if (strcmp(options->labs[i], id) == 0)
            return true;
    if (options->lab_count == RESULT_MAX_LABS)
        return check_fail("--lab was given more than %d times", RESULT_MAX_LABS);
    options->labs[options->lab_count++] = id;
    return true;
}

static bool parse_format(Options *options, const char *format) {
    return report_parse_format(&options->format, format) ||
           check_fail("--format takes text, json, html, gradescope or check50, not \"%s\"", format);
}

static bool parse_jobs(Options *options, const char *text) {
    char *end;
    options->jobs = (int)strtol(text, &end, 10);
    return (*end == '\0' && options->jobs >= 1 && options->jobs <= 256) ||
           check_fail("-j takes a number from 1 to 256, not \"%s\"", text);
}

static bool add_only(Options *options, const char *name) {
    const char **only = realloc(options->only, sizeof *only * (size_t)(options->only_count + 1));
    INVARIANT(only);
    options->only = only;
    options->only[options->only_count++] = name;
    return true;
}

static bool parse_option(Options *options, int option, const char *value) {
    switch (option) {
    case 'l':
        return parse_lab(options, value);
    case 's':
        return parse_seed(options, value);
    case 'c':
        return context_parse(&options->grade.context, value);
    case 'f':
        return parse_format(options, value);
    case 'o':
        options->output = value;
        return true;
    case 'R':
        options->record = true;
        return true;
    case 't':
        return parse_timeout(options, value);
    case 'J':
        return jail_parse_route(&options->route, value);
    case 'T':
        return options->trusted = true;
    case 'n':
        return options->grade.no_swap = true;
    case 'C':
        options->class_folder = value;
        return true;
    case 'j':
        return parse_jobs(options, value);
    case 'O':
        return add_only(options, value);
    case 'r':
        return options->resume = true;
    case 'g':
        return options->gather = true;
    case 'L':
        return options->list = true;
    default:
        return check_fail("unknown option, or one without its value");
    }
}

static bool is_folder(const char *path) {
    struct stat info;
    return (stat(path, &info) == 0 && S_ISDIR(info.st_mode)) || check_fail("%s is not a folder", path);
}

static bool check_operands(Options *options, int count, char **arguments) {
    if (options->trusted && options->route != JAIL_NONE)
        return check_fail("--trusted and --jail exclude each other");
    if (options->class_folder) {
        if (options->trusted)
            return check_fail("a class is graded in the jail only: --trusted does not go with --class");
        if (count > 0)
            return check_fail("with --class there is no SUBMISSION: \"%s\"", arguments[0]);
        return (options->output || options->list || check_fail("--class needs --output OUT")) &&
               is_folder(options->class_folder);
    }
    if (options->jobs || options->resume || options->gather || options->list || options->only)
        return check_fail("-j, --resume, --only, --gather and --list go with --class");
    if (count != 1)
        return check_fail("give one SUBMISSION");
    options->submission = arguments[0];
    return is_folder(options->submission);
}

bool options_parse(Options *options, int count, char **arguments) {
    static const struct option table[] = {{"lab", required_argument, NULL, 'l'},
                                          {"seed", required_argument, NULL, 's'},
                                          {"context", required_argument, NULL, 'c'},
                                          {"format", required_argument, NULL, 'f'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"timeout", required_argument, NULL, 't'},
                                          {"jail", required_argument, NULL, 'J'},
                                          {"trusted", no_argument, NULL, 'T'},
                                          {"record", no_argument, NULL, 'R'},
                                          {"class", required_argument, NULL, 'C'},
                                          {"only", required_argument, NULL, 'O'},
                                          {"resume", no_argument, NULL, 'r'},
                                          {"gather", no_argument, NULL, 'g'},
                                          {"list", no_argument, NULL, 'L'},
                                          {"no-swap", no_argument, NULL, 'n'},
                                          {"help", no_argument, NULL, 'h'},
                                          {0}};
    const char *context = getenv("SHADOW_LAB_CONTEXT");
    *options = (Options){.grade = {.seconds = 20}};
    if (context && !context_parse(&options->grade.context, context))
        return false;
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "j:", table, NULL)) != -1;) {
        if (option == 'h') {
            fputs(options_usage, stdout);
            exit(EXIT_ALL_PASSED);
        }
        if (!parse_option(options, option, optarg))
            return false;
    }
    return check_operands(options, count - optind, arguments + optind);
}
