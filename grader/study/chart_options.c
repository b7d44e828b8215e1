#include "study/chart_options.h"

#include "scene/check.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char chart_options_usage[] =
    "usage: build/chart [options]\n"
    "       build/chart --compare A.csv B.csv\n"
    "  --scene NAME      this scene only; may be repeated\n"
    "  --lab NN          only the scenes in which lab NN takes part\n"
    "  --submission DIR  its lab NN is charted, too (labs/ or the folder of one lab)\n"
    "  --trusted         the submission is my own work: no jail\n"
    "  --quick           small pictures and few frames: under a minute\n"
    "  --frames N        of each setting (30; 6 with --quick)\n"
    "  --size WxH        640x480 (320x240 with --quick)\n"
    "  --output DIR      default build/study; what is measured there is not measured again\n";

enum { MOST_FRAMES = 1000, MOST_SIDE = PROTOCOL_MAX_SIZE };

static bool take_number(int *number, const char *text, int most) {
    char *end;
    long value = strtol(text, &end, 10);
    *number = (int)value;
    return (*text && *end == '\0' && value > 0 && value <= most) ||
           check_fail("a number from 1 to %d is needed, not \"%s\"", most, text);
}

static bool take_size(MetricsSize *size, const char *text) {
    int used = 0;
    bool ok = sscanf(text, "%dx%d%n", &size->width, &size->height, &used) == 2 && text[used] == '\0' &&
              size->width > 0 && size->height > 0 && size->width <= MOST_SIDE && size->height <= MOST_SIDE;
    return ok || check_fail("--size takes WIDTHxHEIGHT up to %d, not \"%s\"", MOST_SIDE, text);
}

static const StudyScene *find_scene(const char *name) {
    for (int i = 0; study_scene(i); i++)
        if (strcmp(study_scene(i)->name, name) == 0)
            return study_scene(i);
    return NULL;
}

static bool take_scene(ChartOptions *options, const char *name) {
    if (!find_scene(name)) {
        char names[256] = "";
        for (int i = 0; study_scene(i); i++)
            check_append(names, sizeof names, " %s", study_scene(i)->name);
        return check_fail("there is no scene \"%s\"; there are%s", name, names);
    }
    if (options->scene_count == CHART_OPTIONS_SCENES)
        return check_fail("--scene is given more than %d times", CHART_OPTIONS_SCENES);
    options->scenes[options->scene_count++] = name;
    return true;
}

static bool take_option(ChartOptions *options, int option, char *value) {
    switch (option) {
    case 'n':
        return take_scene(options, value);
    case 'l':
        options->lab = value;
        return true;
    case 's':
        options->submission = value;
        return true;
    case 'q':
        options->quick = true;
        return true;
    case 'f':
        return take_number(&options->frames, value, MOST_FRAMES);
    case 'z':
        return take_size(&options->size, value);
    case 'o':
        options->output = value;
        return true;
    case 't':
        options->trusted = true;
        return true;
    case 'c':
        options->compare = true;
        return true;
    default:
        return check_fail("unknown option, or one without its value");
    }
}

bool chart_options_parse(ChartOptions *options, int count, char **arguments) {
    static const struct option table[] = {
        {"scene", required_argument, NULL, 'n'},      {"lab", required_argument, NULL, 'l'},
        {"submission", required_argument, NULL, 's'}, {"quick", no_argument, NULL, 'q'},
        {"frames", required_argument, NULL, 'f'},     {"size", required_argument, NULL, 'z'},
        {"output", required_argument, NULL, 'o'},     {"trusted", no_argument, NULL, 't'},
        {"compare", no_argument, NULL, 'c'},          {0}};
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;)
        if (!take_option(options, option, optarg))
            return false;
    if (options->compare ? count - optind != 2 : count != optind)
        return check_fail(options->compare ? "--compare takes two files" : "unknown argument \"%s\"",
                          arguments[optind]);
    if (options->submission && !options->lab)
        return check_fail("--submission needs the --lab that is charted");
    return true;
}

bool chart_options_want(const ChartOptions *options, const StudyScene *scene) {
    bool named = options->scene_count == 0;
    for (int i = 0; i < options->scene_count; i++)
        named = named || strcmp(options->scenes[i], scene->name) == 0;
    return named && (!options->lab || measure_concerns(scene, options->lab));
}
