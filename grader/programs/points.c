// points: measures a student's lab in the settings that were recorded of ours, and prints both as a table.
#include "base/command_line.h"
#include "base/csv_write.h"
#include "base/option_values.h"
#include "base/places.h"
#include "compile/rubric_file.h"
#include "exam/handed_out.h"
#include "points/own_points.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

typedef struct PointsCommand {
    char lab[3];
    const char *submission;
    ContextKind context;
} PointsCommand;

#define AT(field) offsetof(PointsCommand, field)
static const Option options[] = {
    {"lab", 0, "NN", "the lab", AT(lab), option_lab},
    {"context", 0, "C", "osmesa or egl (default: the first that is here)", AT(context), option_context},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    PointsCommand *command = settings;
    command->submission = operands->texts[0];
    return command->lab[0] || check_fail("--lab NN is needed");
}

static const CommandLine command_line = {
    .program = "points",
    .forms = "--lab NN [options] SUBMISSION",
    .about =
        "Draws your lab in the settings that were recorded of ours, and prints times and errors of both as\n"
        "CSV. It runs your lab without a jail: for who wrote it.\n",
    .options = options,
    .ending = "exit status: 0; 1 nothing of yours draws; 2 usage; 3 there are no recorded points\n",
    .operand = "SUBMISSION",
    .least = 1,
    .most = 1,
    .check = check,
};

typedef struct Points {
    Rubric rubric;
    RecordedStudy study;
    OwnLab own, yardstick;
    int drawn;
} Points;

static void print_row(const RecordedScene *scene, const RecordedPoint *point, const char *whose, double ms,
                      double error, const char *message) {
    const char *cells[] = {scene->name, scene->title, point->family, point->name, whose};
    for (int i = 0; i < 5; i++) {
        csv_write_cell(stdout, cells[i]);
        putchar(',');
    }
    printf("%.6g,%.6g,", ms, error);
    csv_write_cell(stdout, message);
    putchar('\n');
}

static bool measure_scene(Points *points, int i) {
    static Scene scene;
    static Image truth;
    const RecordedScene *recorded = &points->study.scenes[i];
    double here;
    if (!recorded_study_scene(&points->study, i, &scene, &truth) ||
        !own_lab_yardstick(&points->yardstick, &scene, truth.width, truth.height, &here))
        return false;
    for (int p = 0; p < recorded->point_count; p++) {
        const RecordedPoint *point = &recorded->points[p];
        OwnPoint own;
        own_lab_measure(&points->own, point, &scene, &truth, &own);
        print_row(recorded, point, "recorded", point->milliseconds * here / recorded->yardstick, point->error,
                  "");
        print_row(recorded, point, "yours", own.milliseconds, own.error, own.message);
        points->drawn += own.drawn;
        fprintf(stderr, "\r%s: %d of %d settings", recorded->name, p + 1, recorded->point_count);
    }
    fputc('\n', stderr);
    return true;
}

static bool find(char path[FILES_PATH], const char *labs, const char *id) {
    places_lab_of(path, labs, id);
    return files_exists(path) || check_fail("there is no lab %s in %s", id, labs);
}

// What was handed out lies in the kit; here, beside the solutions, it is labs/.
static bool open_labs(Points *points, const PointsCommand *command) {
    char handed_out[FILES_PATH], own[FILES_PATH], labs[FILES_PATH];
    places_path(labs, handed_out_alone() ? "grader/recorded/labs" : "labs");
    return find(own, command->submission, command->lab) && find(handed_out, labs, command->lab) &&
           own_lab_open(&points->yardstick, &points->rubric, handed_out, command->context) &&
           own_lab_open(&points->own, &points->rubric, own, command->context);
}

int main(int count, char **arguments) {
    static PointsCommand command;
    static Points points;
    char folder[FILES_PATH];
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &command.context);
    const bool known = places_find_lab(folder, command.lab) && rubric_load(&points.rubric, folder) &&
                       recorded_study_load(&points.study, &points.rubric);
    bool ok = known && open_labs(&points, &command);
    if (ok)
        puts("scene,title,method,setting,whose,ms,error,message");
    for (int i = 0; ok && i < points.study.scene_count; i++)
        ok = measure_scene(&points, i);
    if (!ok)
        fprintf(stderr, "points: %s\n", check_message());
    own_lab_close(&points.own);
    own_lab_close(&points.yardstick);
    recorded_study_destroy(&points.study);
    rubric_destroy(&points.rubric);
    return !known ? 3 : ok && points.drawn > 0 ? 0 : 1;
}
