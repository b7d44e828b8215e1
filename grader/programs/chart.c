// chart: measures speed and error of the labs' methods in the scenes of the study, and charts one against the
// other.
#include "scene/check.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "study/chart_svg.h"
#include "study/cost_chart.h"
#include "study/findings_csv.h"
#include "study/growing_file.h"
#include "study/scene_list.h"
#include "study/chart_page.h"
#include "study/verdict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SCENES = 64, MOST_FRAMES = 1000, MOST_SIDE = PROTOCOL_MAX_SIZE };

typedef struct ChartCommand {
    const char *scenes[MOST_SCENES], *submission, *output;
    char lab[3]; // "": all
    int scene_count, frames;
    uint32_t without; // as LabArtist has it
    MetricsSize size;
    bool quick, compare, list;
    char **compared; // two files
    bool trusted;    // no jail for the submission
    ContextKind context;
} ChartCommand;

static bool take_scene(void *target, const char *name) {
    ChartCommand *command = target;
    if (!study_scene_named(name)) {
        char names[1024] = "";
        for (int i = 0; study_scene(i); i++)
            check_append(names, sizeof names, " %s", study_scene(i)->name);
        return check_fail("takes a scene of the study: there is no scene \"%s\"; there are%s", name, names);
    }
    if (command->scene_count == MOST_SCENES)
        return check_fail("is given more than %d times", MOST_SCENES);
    command->scenes[command->scene_count++] = name;
    return true;
}

static bool take_frames(void *target, const char *text) {
    return option_whole(target, text, 1, MOST_FRAMES);
}

static bool take_size(void *target, const char *text) {
    MetricsSize *size = target;
    return option_size(&size->width, &size->height, text, MOST_SIDE);
}

static bool take_without(void *target, const char *text) {
    return option_bit(target, text, SCENE_MAX_OBJECTS - 1);
}

#define AT(field) offsetof(ChartCommand, field)
static const Option options[] = {
    {"scene", 0, "NAME", "this scene only; may be repeated", 0, take_scene},
    {"lab", 0, "NN", "only the scenes in which lab NN takes part", AT(lab), option_lab},
    {"submission", 0, "DIR", "its lab NN is charted, too (labs/ or the folder of one lab)", AT(submission),
     option_text},
    {"trusted", 0, NULL, "the submission is my own work: no jail", AT(trusted), option_flag},
    {"context", 0, "C",
     "osmesa: CPU times (default; where there is no OSMesa, by EGL); egl: times of the GPU that EGL\nfinds",
     AT(context), option_context},
    {"quick", 0, NULL,
     "small pictures and few frames: some minutes; their pixels are larger, so less is enough", AT(quick),
     option_flag},
    {"frames", 0, "N", "of each setting (30; 6 with --quick)", AT(frames), take_frames},
    {"size", 0, "WxH", "640x480 (320x240 with --quick)", AT(size), take_size},
    {"output", 0, "DIR", "default build/study; what is measured there is not measured again", AT(output),
     option_text},
    {"without", 0, "N", "object N is left out of all scenes: does a verdict change? May be repeated",
     AT(without), take_without},
    {"list", 0, NULL,
     "print of each scene its name, how many objects it has, its chart's title, and the methods in it",
     AT(list), option_flag},
    {"compare", 0, NULL, "compare two tables that build/chart has written", AT(compare), option_flag},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    ChartCommand *command = settings;
    command->compared = operands->texts;
    if (command->compare && operands->count != 2)
        return check_fail("--compare takes two files");
    if (!command->compare && operands->count > 0)
        return check_fail("\"%s\" is not an option", operands->texts[0]);
    if (command->submission && command->context == CONTEXT_EGL && !command->trusted)
        return check_fail("--context egl measures a submission with --trusted only: a jail has no GPU");
    return !command->submission || command->lab[0] ||
           check_fail("--submission needs the --lab that is charted");
}

static const CommandLine command_line = {
    .program = "chart",
    .forms = "[options]\n--compare A.csv B.csv",
    .about = "Measures speed and error of the labs' methods in the scenes of the study, and charts them.\n",
    .options = options,
    .ending =
        "exit status: 0; 1 there is nothing to measure, or --compare finds what noise does not explain;\n"
        "2 usage; 3 it could not measure\n",
    .operand = "file",
    .most = 2,
    .check = check,
};

// Is this scene to be measured?
static bool is_wanted(const ChartCommand *command, const StudyScene *scene) {
    bool named = command->scene_count == 0;
    for (int i = 0; i < command->scene_count; i++)
        named = named || strcmp(command->scenes[i], scene->name) == 0;
    return named && (!command->lab[0] || measure_concerns(scene, command->lab));
}

typedef struct Output {
    GrowingFile csv, views, lines, page, needs;
    int scenes;
} Output;

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
    char need[VERDICT_TEXT];
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
    if (!measure_scene(plan, scene, &findings) || !cost_chart(&findings, plan->output) ||
        !chart_draw(&findings, CHART_TIME, plan->output))
        return false;
    findings_csv_write(output->csv.out, &findings);
    findings_csv_views_write(output->views.out, &findings);
    findings_csv_lines_write(output->lines.out, &findings);
    report(&findings, output->needs.out);
    return chart_page_add(output->page.out, plan, &findings, output->scenes++ == 0);
}

static bool open_output(StudyPlan *plan, Output *output) {
    char path[FILES_PATH];
    files_join(path, plan->output, "frames/");
    if (!files_make_folder(path))
        return false;
    files_join(path, plan->output, "truth/");
    if (!files_make_folder(path))
        return false;
    files_join(path, plan->output, "state");
    if (!measurements_open(&plan->state, path))
        return false;
    return growing_file_begin(&output->csv, plan->output, "chart.csv") &&
           growing_file_begin(&output->views, plan->output, "views.csv") &&
           growing_file_begin(&output->lines, plan->output, "lines.csv") &&
           growing_file_begin(&output->page, plan->output, "chart.html") &&
           growing_file_begin(&output->needs, plan->output, "needs.txt");
}

// Without an object that no scene has, the study would be the whole one.
static bool has_left_out(const ChartCommand *command) {
    int most = 0, last = 0;
    for (int i = 0; study_scene(i); i++)
        if (is_wanted(command, study_scene(i)) && study_count_objects(study_scene(i)) > most)
            most = study_count_objects(study_scene(i));
    while (command->without >> last > 1)
        last++;
    return command->without >> most == 0 ||
           check_fail("none of these scenes has an object %d; --list tells how many each has", last);
}

// Before anything is measured: an hour later would be late.
static bool has_submission(const ChartCommand *command) {
    char folder[FILES_PATH], path[FILES_PATH];
    if (!command->submission)
        return true;
    places_lab_of(folder, command->submission, command->lab);
    files_join(path, folder, "lab.c");
    return files_exists(path) || check_fail("there is no lab %s in %s: no lab.c in it or in %s-*/",
                                            command->lab, command->submission, command->lab);
}

static bool has_scene(const ChartCommand *command) {
    bool any = false;
    for (int i = 0; !any && study_scene(i); i++)
        any = is_wanted(command, study_scene(i));
    return any || check_fail("no scene of the study has settings of lab %s", command->lab);
}

static bool study(const ChartCommand *command, StudyPlan *plan) {
    static Output output;
    if (!open_output(plan, &output) || !chart_page_begin(output.page.out))
        return false;
    findings_csv_head(output.csv.out);
    findings_csv_views_head(output.views.out);
    findings_csv_lines_head(output.lines.out);
    for (int i = 0; study_scene(i); i++)
        if (is_wanted(command, study_scene(i)) && !chart_scene(plan, study_scene(i), &output))
            return false;
    bool ok = chart_page_end(output.page.out);
    ok = growing_file_end(&output.csv) && ok;
    ok = growing_file_end(&output.views) && ok;
    ok = growing_file_end(&output.lines) && ok;
    ok = growing_file_end(&output.needs) && ok;
    ok = growing_file_end(&output.page) && ok;
    printf("%s: open it in a browser; chart.csv, views.csv, lines.csv and the pictures SCENE.svg and "
           "SCENE-cost.svg lie beside it\n",
           output.page.path);
    return ok;
}

// Untrusted code is compiled and run in a jail.
static bool choose_jail(const ChartCommand *command, StudyPlan *plan, Jail *jail) {
    if (!command->submission || command->trusted)
        return true;
    return jail_choose(jail, JAIL_NONE, false, "chart", &plan->artists.jail);
}

static int compare(char **paths) {
    int unexplained;
    if (findings_csv_compare(paths[0], paths[1], stdout, &unexplained))
        return unexplained > 0;
    fprintf(stderr, "chart: %s\n", check_message());
    return 2;
}

int main(int count, char **arguments) {
    static ChartCommand command;
    static StudyPlan plan;
    static Jail jail;
    command_line_take(&command_line, &command, count, arguments);
    if (command.compare)
        return compare(command.compared);
    if (command.list)
        return scene_list_write(stdout), 0;
    ContextKind drawing = command.context; // CONTEXT_ANY stays: only who asks for EGL gets a GPU's times
    command_line_settle_context(&command_line, &drawing);
    char standard[FILES_PATH];
    places_build_path(standard, "study");
    plan.output = command.output ? command.output : standard;
    plan.size = command.size.width ? command.size
                : command.quick    ? (MetricsSize){320, 240}
                                   : (MetricsSize){STUDY_WIDTH, STUDY_HEIGHT};
    plan.frames = command.frames ? command.frames : command.quick ? 6 : 30;
    plan.artists.context = command.context;
    plan.artists.without = command.without;
    plan.artists.submission_lab = command.lab[0] ? command.lab : NULL;
    plan.artists.submission = command.submission;
    const bool asked = has_scene(&command) && has_left_out(&command) && has_submission(&command);
    const bool ok = asked && choose_jail(&command, &plan, &jail) && study(&command, &plan);
    if (!ok)
        fprintf(stderr, "\nchart: %s\n", check_message());
    lab_artists_dismiss(&plan.artists);
    measurements_close(&plan.state);
    jail_destroy(&jail);
    return ok ? 0 : asked ? 3 : 1;
}
