// record_exams [--lab NN] OUTPUT SEED...: records the exams of all labs (or one) for these seeds, for the
// student's kit (see exam/exam_file.h): what is drawn, the rubrics, the hints, and the mistakes' names and
// hints, but nothing of how they are made.
#include "scene/check.h"
#include "exam/lab_exam.h"
#include "base/places.h"
#include "exam/exam_file.h"

#include <ctype.h>
#include <jansson.h>
#include <signal.h>
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

static bool record_texts(const Rubric *rubric, const char *folder) {
    return write_json(folder, "rubric.json", read_json(rubric, "rubric.json")) &&
           write_json(folder, "hints.json", read_json(rubric, "hints.json")) &&
           write_json(folder, "mistakes.json", public_mistakes(rubric)) &&
           write_json(folder, "alternatives.json", json_array());
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

static bool are_numbers(char **texts) {
    for (; *texts; texts++)
        if (strspn(*texts, "0123456789") != strlen(*texts) || !**texts)
            return false;
    return true;
}

static bool record_all(const char *lab, const char *output, char **seeds) {
    Recording recording = {output, seeds, true};
    if (lab)
        record_lab(lab, &recording);
    else if (!places_list_labs(record_lab, &recording))
        return false;
    return recording.ok && write_json(output, "seeds.json", list_seeds(seeds));
}

int main(int count, char **arguments) {
    bool one = count > 2 && strcmp(arguments[1], "--lab") == 0;
    int first = one ? 3 : 1;
    if (count < first + 2 || !are_numbers(arguments + first + 1)) {
        fputs("usage: build/record_exams [--lab NN] OUTPUT SEED...\n", stderr);
        return 2;
    }
    signal(SIGPIPE, SIG_IGN);
    bool ok = record_all(one ? arguments[2] : NULL, arguments[first], arguments + first + 1);
    if (!ok)
        fprintf(stderr, "record_exams: %s\n", check_message());
    return ok ? 0 : 1;
}
