// Every object of every scene is there for something that is graded, and what is not is found.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "proof/lab_changes.h"
#include "proof/scene_needs.h"
#include "base/places.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SEEDS = 4 };
static const double ENOUGH = 0.002; // of the picture: 30 to 50 of an exam's pixels

static WorkerClient worker; // draws all labs

static void load(Rubric *rubric, const char *id) {
    char folder[FILES_PATH];
    assert_true(places_find_lab(folder, id) && rubric_load(rubric, folder));
}

static void check_scene(const char *id, const SceneNeeds *economy, const char *page) {
    char text[ECONOMY_TEXT];
    scene_needs_describe(text, id, economy);
    print_message("%s %.4f\n", text, scene_needs_least(economy));
    assert_true(scene_needs_least(economy) >= ENOUGH);
    assert_non_null(strstr(page, text));
}

// Under the sanitizers, which make all labs again, one will do.
static void check_lab(const char *id, void *page) {
    static SceneNeeds economies[ECONOMY_MAX_SCENES];
    Rubric rubric;
    if (getenv("QUICK") && strcmp(id, "03") != 0)
        return;
    load(&rubric, id);
    int count = scene_needs_measure(economies, &rubric, &worker, SEEDS, ENOUGH);
    assert_true(count > 0);
    for (int i = 0; i < count; i++)
        check_scene(id, &economies[i], page);
    rubric_destroy(&rubric);
}

static void test_scenes(void **unused) {
    (void)unused;
    char path[FILES_PATH];
    places_path(path, "grader/proof/SCENES.md");
    char *page = files_read(path, 1 << 20);
    assert_non_null(page);
    assert_true(places_list_labs(check_lab, page));
    free(page);
}

// A box below the floor, in the scenes of an exam, is needed for nothing; the floor above it is.
static void test_needless(void **unused) {
    (void)unused;
    Rubric rubric;
    load(&rubric, "03");
    Painters painters = {.rubric = &rubric, .client = worker};
    Exam *exam = calloc(1, sizeof *exam);
    SceneNeeds economy = {.scene = "table spot"};
    assert_true(exam && exam_create(exam, &rubric, &painters, 1));
    int added = exam->variants[0][0].request.scene.object_count;
    for (int c = 0; c < rubric.check_count; c++)
        for (int n = 0; n < rubric.checks[c].variants; n++) {
            Scene *scene = &exam->variants[c][n].request.scene;
            scene->objects[scene->object_count++] =
                (Object){.shape = SHAPE_BOX, .world_from_object = glms_translate_make(vec3_make(0, -3, 0))};
        }
    assert_true(scene_needs_look(&economy, exam, &painters, ENOUGH));
    print_message("a box below the floor: %.4f, the floor: %.4f\n", economy.need[added], economy.need[0]);
    assert_true(economy.need[added] == 0 && economy.need[0] > ENOUGH);
    assert_true(scene_needs_least(&economy) < ENOUGH);
    exam_destroy(exam);
    free(exam);
    worker = painters.client;
    painters.client = (WorkerClient){0};
    painters_destroy(&painters);
    rubric_destroy(&rubric);
}

// A second light, in an exam whose checks look at the map of the first one, is needed for nothing.
static void test_needless_light(void **unused) {
    (void)unused;
    Rubric rubric;
    load(&rubric, "03");
    rubric.check_count = 1; // the map
    Painters painters = {.rubric = &rubric, .client = worker};
    Exam *exam = calloc(1, sizeof *exam);
    SceneNeeds economy = {.scene = "table spot"};
    assert_true(exam && exam_create(exam, &rubric, &painters, 1));
    for (int n = 0; n < rubric.checks[0].variants; n++) {
        Scene *scene = &exam->variants[0][n].request.scene;
        scene->lights[scene->light_count++] = scene->lights[0];
    }
    assert_true(scene_needs_look(&economy, exam, &painters, ENOUGH));
    print_message("a second light: %.4f\n", economy.need[SCENE_MAX_OBJECTS + 1]);
    assert_true(economy.need[SCENE_MAX_OBJECTS] == 0 && economy.need[SCENE_MAX_OBJECTS + 1] == 0);
    assert_true(scene_needs_least(&economy) < ENOUGH);
    exam_destroy(exam);
    free(exam);
    worker = painters.client;
    painters.client = (WorkerClient){0};
    painters_destroy(&painters);
    rubric_destroy(&rubric);
}

// The number of a change; the test fails without it.
static int find_change(const LabChanges *changes, const char *task, const char *before,
                       const char *replacement) {
    for (int i = 0; i < changes->mutants.count; i++) {
        const Mutant *mutant = &changes->mutants.list[i];
        if (strcmp(mutant->task, task) == 0 && strcmp(mutant->before, before) == 0 &&
            strcmp(mutant->replacement, replacement) == 0)
            return i;
    }
    fail_msg("lab 03 has no change of task %s from %s to %s", task, before, replacement);
    return -1;
}

// "Always lit" is noticed by a box on a floor, and no more without the box; one below the floor changes
// nothing, nor does any object of another scene.
static void test_worth(void **unused) {
    (void)unused;
    enum { BOX = 1, BELOW = 2 };
    static LabChanges changes;
    const GradeOptions options = {.seed = 1};
    Absence absences[3];
    char losses[4];
    assert_true(lab_changes_open(&changes, "03"));
    Rubric *rubric = &changes.examiner.rubric;
    while (strcmp(rubric->checks[0].name, "comparison: spot light") != 0)
        memmove(&rubric->checks[0], &rubric->checks[1], (RUBRIC_MAX_CHECKS - 1) * sizeof rubric->checks[0]);
    rubric->check_count = rubric->checks[0].scene_count = 1; // a box on a floor, and no other scene
    Exam *exam = changes.court.exam = lab_exam_exam(&changes.examiner, &options);
    assert_non_null(exam);
    for (int n = 0; n < rubric->checks[0].variants; n++) {
        exam->variants[0][n].request.scene.objects[BELOW] =
            (Object){.shape = SHAPE_BOX, .world_from_object = glms_translate_make(vec3_make(0, -3, 0))};
        assert_true(absence_draw_variant(&exam->variants[0][n], exam->painters, rubric->checks[0].task));
    }
    assert_true(absence_create(&absences[0], exam, "table spot", BOX) &&
                absence_create(&absences[1], exam, "table spot", BELOW) &&
                absence_create(&absences[2], exam, "table sun", BOX));
    lab_exam_rest(&changes.examiner);
    const Mutant *lit = &changes.mutants.list[find_change(&changes, "3.5", "0.0", "1.0")];
    assert_true(trial_without(&changes.court, lit, absences, 3, losses));
    print_message("always lit: %s\n", losses);
    assert_string_equal(losses, "k..");
    for (int i = 0; i < 3; i++)
        absence_destroy(&absences[i]);
    lab_changes_close(&changes);
}

static int stop(void **unused) {
    (void)unused;
    worker_client_stop(&worker);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_needless), cmocka_unit_test(test_needless_light),
                                       cmocka_unit_test(test_worth), cmocka_unit_test(test_scenes)};
    return cmocka_run_group_tests_name("economy", tests, NULL, stop);
}
