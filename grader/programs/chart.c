// chart: measures speed and error of the labs' methods in the scenes of the study, and charts one against the
// other.
#include "scene/check.h"
#include "base/places.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "study/chart_svg.h"
#include "study/csv.h"
#include "study/chart_options.h"
#include "study/chart_page.h"

#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Files that grow scene by scene in memory; they are written when they are whole.
typedef struct GrowingFile {
    char path[FILES_PATH], *text;
    size_t size;
    FILE *out;
} GrowingFile;

typedef struct Output {
    GrowingFile csv, page, needs;
    int scenes;
} Output;

static bool begin_file(GrowingFile *file, const char *folder, const char *name) {
    files_join(file->path, folder, name);
    file->out = open_memstream(&file->text, &file->size);
    return file->out || check_fail("no memory for %s", file->path);
}

static bool end_file(GrowingFile *file) {
    bool ok = fclose(file->out) == 0 && files_write_whole(file->path, file->text, true);
    free(file->text);
    return ok || check_fail("no memory for %s", file->path);
}

// The same setting of ours, which every one of a submission has.
static int ours_of(const SceneFindings *findings, int submitted) {
    const Method *wanted = &findings->findings[submitted].method;
    int i = 0;
    while (strcmp(findings->findings[i].method.family, wanted->family) != 0 ||
           strcmp(findings->findings[i].method.name, wanted->name) != 0)
        i++;
    return i;
}

static void report_submission(const SceneFindings *findings, int i) {
    const Finding *finding = &findings->findings[i];
    int ours = ours_of(findings, i);
    printf("  yours, %s, %s: ", finding->method.family, finding->method.name);
    if (finding->drawn)
        printf("error %.3g %% (ours %.3g %%), %.3g ms (ours %.3g ms)\n", 100 * findings->points[i].error,
               100 * findings->points[ours].error, findings->points[i].ms, findings->points[ours].ms);
    else
        printf("not drawn: %s\n", finding->message);
}

static void report(const SceneFindings *findings, FILE *needs) {
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
    static SceneFindings findings;
    if (!measure_scene(plan, scene, &findings) || !chart_draw(&findings, plan->output))
        return false;
    csv_write(output->csv.out, &findings);
    report(&findings, output->needs.out);
    return chart_page_add(output->page.out, plan, &findings, output->scenes++ == 0);
}

static bool open_output(StudyPlan *plan, Output *output) {
    char path[FILES_PATH];
    files_join(path, plan->output, "frames/");
    if (!files_make_folder(path))
        return false;
    files_join(path, plan->output, "state");
    if (!measurements_open(&plan->state, path))
        return false;
    return begin_file(&output->csv, plan->output, "chart.csv") &&
           begin_file(&output->page, plan->output, "chart.html") &&
           begin_file(&output->needs, plan->output, "needs.txt");
}

static bool study(const ChartOptions *options, StudyPlan *plan) {
    static Output output;
    if (!open_output(plan, &output) || !chart_page_begin(output.page.out))
        return false;
    csv_head(output.csv.out);
    for (int i = 0; study_scene(i); i++)
        if (chart_options_want(options, study_scene(i)) && !chart_scene(plan, study_scene(i), &output))
            return false;
    if (output.scenes == 0)
        return check_fail("no scene of the study has settings of lab %s", options->lab);
    bool ok = chart_page_end(output.page.out);
    ok = end_file(&output.csv) && ok;
    ok = end_file(&output.needs) && ok;
    ok = end_file(&output.page) && ok;
    printf("%s: open it in a browser; chart.csv and the pictures SCENE.svg lie beside it\n",
           output.page.path);
    return ok;
}

// Untrusted code is compiled and run in a jail.
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
