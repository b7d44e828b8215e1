// chart: measures speed and error of the labs' methods in the scenes of the study, and charts one against the
// other.
#include "check.h"
#include "home.h"
#include "study/chart.h"
#include "study/csv.h"
#include "study/page.h"

#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: build/chart [options]\n"
    "       build/chart --compare A.csv B.csv\n"
    "  --scene NAME      this scene only; may be repeated\n"
    "  --lab NN          only the scenes in which lab NN takes part\n"
    "  --submission DIR  its lab NN is charted, too (labs/ or the folder of one lab)\n"
    "  --quick           small pictures and few frames: under a minute\n"
    "  --frames N        of each setting (30; 6 with --quick)\n"
    "  --size WxH        640x480 (320x240 with --quick)\n"
    "  --output DIR      default build/study; what is measured there is not measured again\n";

enum { MOST_SCENES = 16, MOST_FRAMES = 1000, MOST_SIDE = 4096 };

typedef struct Options {
    const char *scenes[MOST_SCENES], *lab, *submission, *output;
    int scene_count, frames;
    MetricsSize size;
    bool quick, compare;
} Options;

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
    for (const StudyScene *scene = study_scenes; scene->name; scene++)
        if (strcmp(scene->name, name) == 0)
            return scene;
    return NULL;
}

static bool take_scene(Options *options, const char *name) {
    if (!find_scene(name)) {
        char names[256] = "";
        for (const StudyScene *scene = study_scenes; scene->name; scene++)
            check_append(names, sizeof names, " %s", scene->name);
        return check_fail("there is no scene \"%s\"; there are%s", name, names);
    }
    if (options->scene_count == MOST_SCENES)
        return check_fail("--scene is given more than %d times", MOST_SCENES);
    options->scenes[options->scene_count++] = name;
    return true;
}

static bool take_option(Options *options, int option, char *value) {
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
    case 'c':
        options->compare = true;
        return true;
    default:
        return check_fail("unknown option, or one without its value");
    }
}

static bool parse(Options *options, int count, char **arguments) {
    static const struct option table[] = {{"scene", required_argument, NULL, 'n'},
                                          {"lab", required_argument, NULL, 'l'},
                                          {"submission", required_argument, NULL, 's'},
                                          {"quick", no_argument, NULL, 'q'},
                                          {"frames", required_argument, NULL, 'f'},
                                          {"size", required_argument, NULL, 'z'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"compare", no_argument, NULL, 'c'},
                                          {0}};
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

static bool wants(const Options *options, const StudyScene *scene) {
    bool named = options->scene_count == 0;
    for (int i = 0; i < options->scene_count; i++)
        named = named || strcmp(options->scenes[i], scene->name) == 0;
    return named && (!options->lab || measure_concerns(scene, options->lab));
}

// The files that grow scene by scene; they get their names when they are whole.
typedef struct Output {
    char csv_path[FILES_PATH], page_path[FILES_PATH], needs_path[FILES_PATH];
    FILE *csv, *page, *needs;
    int scenes;
} Output;

static FILE *open_part(char path[FILES_PATH], const char *folder, const char *name) {
    char part[FILES_PATH + 8];
    files_join(path, folder, name);
    snprintf(part, sizeof part, "%s.part", path);
    FILE *file = fopen(part, "w");
    if (!file)
        check_fail("%s: %s", part, strerror(errno));
    return file;
}

static bool close_part(FILE *file, const char *path) {
    char part[FILES_PATH + 8];
    snprintf(part, sizeof part, "%s.part", path);
    bool ok = file && !ferror(file);
    return (file && fclose(file) == 0 && ok && rename(part, path) == 0) ||
           check_fail("%s cannot be written", path);
}

static void report(const Findings *findings, FILE *needs) {
    char need[512];
    findings_tell(findings, need, sizeof need);
    printf("%s: %s\n", findings->scene->name, need);
    fprintf(needs, "%s: %s\n", findings->scene->name, need);
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].message[0])
            printf("  not drawn: %s, %s: %s\n", findings->findings[i].method.family,
                   findings->findings[i].method.name, findings->findings[i].message);
    fflush(stdout);
}

static bool study_scene(StudyPlan *plan, const StudyScene *scene, Output *output) {
    static Findings findings;
    if (!measure_scene(plan, scene, &findings) || !chart_draw(&findings, plan->output))
        return false;
    csv_write(output->csv, &findings);
    report(&findings, output->needs);
    return page_add(output->page, plan, &findings, output->scenes++ == 0);
}

static bool open_output(StudyPlan *plan, Output *output) {
    char path[FILES_PATH];
    files_join(path, plan->output, "frames/");
    if (!files_make_folder(path))
        return false;
    files_join(path, plan->output, "state");
    if (!state_open(&plan->state, path))
        return false;
    output->csv = open_part(output->csv_path, plan->output, "chart.csv");
    output->page = open_part(output->page_path, plan->output, "chart.html");
    output->needs = open_part(output->needs_path, plan->output, "needs.txt");
    return output->csv && output->page && output->needs;
}

static bool study(const Options *options, StudyPlan *plan) {
    static Output output;
    if (!open_output(plan, &output) || !page_begin(output.page))
        return false;
    csv_head(output.csv);
    for (const StudyScene *scene = study_scenes; scene->name; scene++)
        if (wants(options, scene) && !study_scene(plan, scene, &output))
            return false;
    if (output.scenes == 0)
        return check_fail("no scene of the study has settings of lab %s", options->lab);
    bool ok = page_end(output.page);
    ok = close_part(output.csv, output.csv_path) && ok;
    ok = close_part(output.needs, output.needs_path) && ok;
    ok = close_part(output.page, output.page_path) && ok;
    printf("%s: open it in a browser; chart.csv and the pictures SCENE.svg lie beside it\n",
           output.page_path);
    return ok;
}

static int compare(char **paths) {
    int unexplained;
    if (csv_compare(paths[0], paths[1], stdout, &unexplained))
        return unexplained > 0;
    fprintf(stderr, "chart: %s\n", check_message());
    return 2;
}

int main(int count, char **arguments) {
    static Options options;
    static StudyPlan plan;
    if (!parse(&options, count, arguments)) {
        fprintf(stderr, "chart: %s\n%s", check_message(), usage);
        return 2;
    }
    if (options.compare)
        return compare(arguments + optind);
    signal(SIGPIPE, SIG_IGN);
    char standard[FILES_PATH];
    home_build_path(standard, "study");
    plan.output = options.output ? options.output : standard;
    plan.size = options.size.width ? options.size
                : options.quick    ? (MetricsSize){320, 240}
                                   : (MetricsSize){640, 480};
    plan.frames = options.frames ? options.frames : options.quick ? 6 : 30;
    plan.crew.submission_lab = options.lab;
    plan.crew.submission = options.submission;
    bool ok = study(&options, &plan);
    if (!ok)
        fprintf(stderr, "\nchart: %s\n", check_message());
    crew_dismiss(&plan.crew);
    state_close(&plan.state);
    return ok ? 0 : 1;
}
