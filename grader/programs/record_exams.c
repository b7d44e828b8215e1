// record_exams: records the exams of all labs (or one) for some seeds, for the student's
// kit (see exam/exam_file.h): what is drawn, the rubrics, the hints, and the mistakes' names and hints, but
// nothing of how they are made.
#include "scene/check.h"
#include "exam/lab_exam.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "exam/exam_file.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Recording {
    const char *output;
    char **seeds;
    bool ok;
} Recording;

static bool write_json(const char *folder, const char *name, json_t *json) {
    char path[FILES_PATH];
    files_join(path, folder, name);
    bool ok = json && json_dump_file(json, path, JSON_INDENT(1)) == 0;
    json_decref(json);
    return ok || check_fail("%s cannot be written", path);
}

static json_t *read_json(const Rubric *rubric, const char *name) {
    char path[FILES_PATH];
    files_join(path, rubric->folder, name);
    return json_load_file(path, 0, NULL);
}

static json_t *public_mistakes(const Rubric *rubric) {
    json_t *list = read_json(rubric, "mistakes.json"), *entry;
    size_t i;
    json_array_foreach(list, i, entry) json_object_del(entry, "edits");
    return list;
}

// The names of those whose pictures are recorded, for the rubric asks for them.
static json_t *public_alternatives(const Rubric *rubric) {
    json_t *list = json_array();
    for (int a = 0; a < rubric->also_count; a++)
        json_array_append_new(list, json_pack("{s:s}", "name", rubric->also[a]->name));
    return list;
}

// A lab need not have it.
static bool record_if_there(const Rubric *rubric, const char *folder, const char *name) {
    json_t *json = read_json(rubric, name);
    return !json || write_json(folder, name, json);
}

static bool record_texts(const Rubric *rubric, const char *folder) {
    return record_if_there(rubric, folder, "afterword.json") &&
           record_if_there(rubric, folder, "captions.json") &&
           write_json(folder, "rubric.json", read_json(rubric, "rubric.json")) &&
           write_json(folder, "hints.json", read_json(rubric, "hints.json")) &&
           write_json(folder, "mistakes.json", public_mistakes(rubric)) &&
           write_json(folder, "alternatives.json", public_alternatives(rubric));
}

static void record_lab(const char *id, void *context) {
    static LabExam examiner;
    Recording *recording = context;
    char folder[FILES_PATH];
    if (!recording->ok || !(recording->ok = lab_exam_open(&examiner, id)))
        return;
    files_join(folder, recording->output, strrchr(examiner.rubric.folder, '/') + 1);
    check_append(folder, sizeof folder, "/");
    bool ok = files_make_folder(folder) && record_texts(&examiner.rubric, folder);
    for (char **seed = recording->seeds; ok && *seed; seed++) {
        const GradeOptions options = {.seed = strtoull(*seed, NULL, 10)};
        Exam *exam = lab_exam_exam(&examiner, &options);
        ok = exam && exam_file_save(exam, folder);
        lab_exam_forget(&examiner);
    }
    lab_exam_close(&examiner);
    recording->ok = ok;
}

static json_t *list_seeds(char **seeds) {
    json_t *list = json_array();
    for (; *seeds; seeds++)
        json_array_append_new(list, json_string(*seeds));
    return list;
}

typedef struct RecordCommand {
    char lab[3]; // "": all
    const char *output;
    char **seeds;
} RecordCommand;

static const Option options[] = {{"lab", 0, "NN", "only this lab", offsetof(RecordCommand, lab), option_lab},
                                 {0}};

static bool check(void *settings, const Operands *operands) {
    RecordCommand *command = settings;
    uint64_t seed;
    command->output = operands->texts[0];
    command->seeds = operands->texts + 1;
    for (int i = 1; i < operands->count; i++)
        if (!option_seed(&seed, operands->texts[i])) {
            check_clear();
            return check_fail("a SEED is a whole number from 0 to 2^64 - 1, not \"%s\"", operands->texts[i]);
        }
    return operands->count > 1 || check_fail("give at least one SEED");
}

static const CommandLine command_line = {
    .program = "record_exams",
    .forms = "[--lab NN] OUTPUT SEED...",
    .about =
        "Records in the folder OUTPUT what the labs' solutions draw for each SEED, for the students' kit.\n",
    .options = options,
    .operand = "OUTPUT",
    .least = 1,
    .most = 1000,
    .check = check,
};

static bool record_all(const RecordCommand *command) {
    Recording recording = {command->output, command->seeds, true};
    if (command->lab[0])
        record_lab(command->lab, &recording);
    else if (!places_list_labs(record_lab, &recording))
        return false;
    return recording.ok && write_json(command->output, "seeds.json", list_seeds(command->seeds));
}

int main(int count, char **arguments) {
    RecordCommand command = {0};
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &context);
    bool ok = record_all(&command);
    if (!ok)
        fprintf(stderr, "record_exams: %s\n", check_message());
    return ok ? 0 : 3;
}
