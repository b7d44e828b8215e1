#include "window/view_options.h"

#include "scene/check.h"
#include "protocol/request_options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char arguments_usage[] = "usage: build/view --lab NN [options]\n"
                               "  --submission DIR  shaped like labs/, or one lab's folder (default labs)\n"
                               "  --scene NAME      scene to begin with\n"
                               "  --seed N          variant of the scene (default 1)\n"
                               "  --view V          picture (default), visibility or a stage of the lab\n"
                               "  --show S          mine (default), reference, split, difference or truth\n"
                               "  --against-truth   split and difference compare with the truth\n"
                               "  --knob NAME=VALUE may be repeated\n"
                               "  --size WxH        of the window (default 800x600)\n"
                               "  --bare            begin without text (key H)\n"
                               "  --timeout S       longest time of a frame of mine (default 10)\n"
                               "  --context C       of the labs: osmesa (default) or egl\n"
                               "  --screenshot FILE save the picture as PNG once it is there, and quit\n"
                               "  --quit-after S    quit after so many seconds\n";

static bool take_show(AppOptions *options, const char *text) {
    static const char *const names[SHOW_COUNT] = {"mine", "reference", "split", "difference", "truth"};
    for (int i = 0; i < SHOW_COUNT; i++)
        if (strcmp(names[i], text) == 0) {
            options->show = (Show)i;
            return true;
        }
    return check_fail("--show takes mine, reference, split, difference or truth, not \"%s\"", text);
}

static bool take_seconds(double *seconds, const char *text) {
    char *end;
    *seconds = strtod(text, &end);
    return (*end == '\0' && *seconds > 0) || check_fail("\"%s\" is no number of seconds", text);
}

static bool take_lab(AppOptions *options, const char *text) {
    size_t length = strspn(text, "0123456789");
    if (length < 1 || length > 2 || text[length] != '\0')
        return check_fail("--lab takes a number like 05, not \"%s\"", text);
    options->lab[0] = length == 2 ? text[0] : '0';
    options->lab[1] = text[length - 1];
    return true;
}

static bool take_option(AppOptions *options, int option, char *value) {
    switch (option) {
    case 'l':
        return take_lab(options, value);
    case 'd':
        return options->submission = value, true;
    case 'n':
        return options->scene = value, true;
    case 's':
        return options->seed = strtoull(value, NULL, 10), true;
    case 'v':
        snprintf(options->request.view, sizeof options->request.view, "%s", value);
        return true;
    case 'w':
        return take_show(options, value);
    case 't':
        return options->against_truth = true;
    case 'k':
        return request_take_knob(&options->request, value);
    case 'z':
        return request_take_size(&options->request, value);
    case 'b':
        return options->bare = true;
    case 'm':
        return take_seconds(&options->seconds, value);
    case 'c':
        return context_parse(&options->context, value);
    case 'p':
        return options->screenshot = value, true;
    case 'h':
        return options->help = true;
    case 'q':
        return take_seconds(&options->quit_after, value);
    default:
        return check_fail("unknown option, or one without its value");
    }
}

bool view_options_parse(AppOptions *options, int count, char **arguments) {
    static const struct option table[] = {{"lab", required_argument, NULL, 'l'},
                                          {"submission", required_argument, NULL, 'd'},
                                          {"scene", required_argument, NULL, 'n'},
                                          {"seed", required_argument, NULL, 's'},
                                          {"view", required_argument, NULL, 'v'},
                                          {"show", required_argument, NULL, 'w'},
                                          {"against-truth", no_argument, NULL, 't'},
                                          {"knob", required_argument, NULL, 'k'},
                                          {"size", required_argument, NULL, 'z'},
                                          {"bare", no_argument, NULL, 'b'},
                                          {"timeout", required_argument, NULL, 'm'},
                                          {"context", required_argument, NULL, 'c'},
                                          {"screenshot", required_argument, NULL, 'p'},
                                          {"quit-after", required_argument, NULL, 'q'},
                                          {"help", no_argument, NULL, 'h'},
                                          {0}};
    *options = (AppOptions){.seed = 1, .seconds = 10, .request = {.width = 800, .height = 600}};
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;)
        if (!take_option(options, option, optarg))
            return false;
    return options->help || (options->lab[0] && optind == count) ||
           check_fail("--lab NN is needed, as in: make run LAB=05");
}
