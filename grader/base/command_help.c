#include "base/command_help.h"

#include "scene/check.h"

#include <string.h>

enum { LEFT = 64 };

// The line at *text; *text goes on to the next one. Its length.
static int next_line(const char **text) {
    const int length = (int)strcspn(*text, "\n");
    *text += length + ((*text)[length] == '\n');
    return length;
}

void command_help_forms(const CommandLine *line, FILE *out) {
    const char *text = line->forms, *begin = text;
    for (const char *before = "usage:"; *text; before = "      ", begin = text) {
        const int length = next_line(&text);
        fprintf(out, "%s build/%s%s%.*s\n", before, line->program, length ? " " : "", length, begin);
    }
    if (!line->forms[0])
        fprintf(out, "usage: build/%s\n", line->program);
}

// "--lab NN", "-j N", "--jobs, -j N".
static void left_side(char text[LEFT], const Option *option) {
    text[0] = '\0';
    if (option->name)
        check_append(text, LEFT, "--%s", option->name);
    if (option->letter)
        check_append(text, LEFT, "%s-%c", option->name ? ", " : "", option->letter);
    if (option->value)
        check_append(text, LEFT, " %s", option->value);
}

static void print_option(const Option *option, int width, FILE *out) {
    char left[LEFT];
    const char *text = option->help, *begin = text;
    left_side(left, option);
    for (; *text; left[0] = '\0', begin = text) {
        const int length = next_line(&text);
        fprintf(out, "  %-*s  %.*s\n", width, left, length, begin);
    }
}

void command_help_print(const CommandLine *line, FILE *out) {
    static const Option help = {"help", 'h', NULL, "say this, and end", 0, NULL};
    char left[LEFT];
    int width = (int)strlen("--help, -h");
    for (const Option *option = line->options; option->help; option++) {
        left_side(left, option);
        if ((int)strlen(left) > width)
            width = (int)strlen(left);
    }
    command_help_forms(line, out);
    fprintf(out, "%s", line->about);
    for (const Option *option = line->options; option->help; option++)
        if (option->name || option->letter)
            print_option(option, width, out);
        else
            fprintf(out, "%s\n", option->help);
    print_option(&help, width, out);
    if (line->ending)
        fprintf(out, "%s", line->ending);
}
