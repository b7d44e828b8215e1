// chart: measures speed and error of the labs' methods in the scenes of the study, and charts one against the
// other.
#include "scene/check.h"
#include "base/places.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "study/chart.h"
#include "study/csv.h"
#include "study/chart_options.h"
#include "study/chart_page.h"

#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

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

// The same setting of ours, which every one of a submission has.
static int ours_of(const Findings *findings, int submitted) {
    const Method *wanted = &findings->findings[submitted].method;
    int i = 0;
    while (strcmp(findings->findings[i].method.family, wanted->family) != 0 ||
           strcmp(findings->findings[i].method.name, wanted->name) != 0)
        i++;
    return i;
}

static void report_submission(const Findings *findings, int i) {
    const Finding *finding = &findings->findings[i];
    int ours = ours_of(findings, i);
    printf("  yours, %s, %s: ", finding->method.family, finding->method.name);
    if (finding->drawn)
        printf("error %.3g %% (ours %.3g %%), %.3g ms (ours %.3g ms)\n", 100 * findings->points[i].error,
               100 * findings->points[ours].error, findings->points[i].ms, findings->points[ours].ms);
    else
        printf("not drawn: %s\n", finding->message);
}

static void report(const Findings *findings, FILE *needs) {
    char need[512];
    findings_tell(findings, need, sizeof need);
    printf("%s: %s\n", findings->scene->name, need);
    fprintf(needs, "%s\t%s\n", findings->scene->title, need);
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].method.submission)
            report_submission(findings, i);
    fflush(stdout);
}

static bool chart_scene(StudyPlan *plan, const StudyScene *scene, Output *output) {
    static Findings findings;
    if (!measure_scene(plan, scene, &findings) || !chart_draw(&findings, plan->output))
        return false;
    csv_write(output->csv, &findings);
    report(&findings, output->needs);
    return chart_page_add(output->page, plan, &findings, output->scenes++ == 0);
}

static bool open_output(StudyPlan *plan, Output *output) {
    char path[FILES_PATH];
    files_join(path, plan->output, "frames/");
    if (!files_make_folder(path))
        return false;
    files_join(path, plan->output, "state");
    if (!measurements_open(&plan->state, path))
        return false;
    output->csv = open_part(output->csv_path, plan->output, "chart.csv");
    output->page = open_part(output->page_path, plan->output, "chart.html");
    output->needs = open_part(output->needs_path, plan->output, "needs.txt");
    return output->csv && output->page && output->needs;
}

static bool study(const ChartOptions *options, StudyPlan *plan) {
    static Output output;
    if (!open_output(plan, &output) || !chart_page_begin(output.page))
        return false;
    csv_head(output.csv);
    for (int i = 0; study_scene(i); i++)
        if (chart_options_want(options, study_scene(i)) && !chart_scene(plan, study_scene(i), &output))
            return false;
    if (output.scenes == 0)
        return check_fail("no scene of the study has settings of lab %s", options->lab);
    bool ok = chart_page_end(output.page);
    ok = close_part(output.csv, output.csv_path) && ok;
    ok = close_part(output.needs, output.needs_path) && ok;
    ok = close_part(output.page, output.page_path) && ok;
    printf("%s: open it in a browser; chart.csv and the pictures SCENE.svg lie beside it\n",
           output.page_path);
    return ok;
}

// Strangers' code is compiled and run in a jail.
static bool choose_jail(const ChartOptions *options, StudyPlan *plan, Jail *jail) {
    if (!options->submission || options->trusted)
        return true;
    return jail_choose(jail, JAIL_NONE, false, "chart", &plan->artists.jail);
}

static int compare(char **paths) {
    int unexplained;
    if (csv_compare(paths[0], paths[1], stdout, &unexplained))
        return unexplained > 0;
    fprintf(stderr, "chart: %s\n", check_message());
    return 2;
}

int main(int count, char **arguments) {
    static ChartOptions options;
    static StudyPlan plan;
    static Jail jail;
    if (!chart_options_parse(&options, count, arguments)) {
        fprintf(stderr, "chart: %s\n%s", check_message(), chart_options_usage);
        return 2;
    }
    if (options.compare)
        return compare(arguments + optind);
    signal(SIGPIPE, SIG_IGN);
    char standard[FILES_PATH];
    places_build_path(standard, "study");
    plan.output = options.output ? options.output : standard;
    plan.size = options.size.width ? options.size
                : options.quick    ? (MetricsSize){320, 240}
                                   : (MetricsSize){640, 480};
    plan.frames = options.frames ? options.frames : options.quick ? 6 : 30;
    plan.artists.submission_lab = options.lab;
    plan.artists.submission = options.submission;
    bool ok = choose_jail(&options, &plan, &jail) && study(&options, &plan);
    if (!ok)
        fprintf(stderr, "\nchart: %s\n", check_message());
    lab_artists_dismiss(&plan.artists);
    measurements_close(&plan.state);
    jail_destroy(&jail);
    return ok ? 0 : 1;
}
