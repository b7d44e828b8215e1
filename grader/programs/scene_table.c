// scene_table: what each lab's scenes are made of, and how much the graded views need it; prints a table
// (Markdown, for grader/proof/SCENES.md). With --power: what each object is worth to the verdicts, with
// --changes also to the mutation test, with --together when several go at once.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "proof/object_worth.h"
#include "proof/scene_needs.h"
#include "proof/scene_power.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SEEDS = 4 };

typedef struct SceneTable {
    WorkerClient worker; // draws all labs
    char lab[3];         // "": all
    bool power, together, changes, broken;
    ObjectWorth needless[OBJECT_WORTH_MOST]; // of one lab: what no known mistake needs
    int needless_count;
} SceneTable;

static void print_row(const char *id, const SceneNeeds *economy) {
    char text[ECONOMY_TEXT];
    scene_needs_describe(text, id, economy);
    printf("%s %.1f |\n", text, 100 * scene_needs_least(economy));
}

static void print_thing(const char *id, const char *scene, int thing, const char *why) {
    const bool light = thing >= SCENE_MAX_OBJECTS;
    const char *excuse = scene_needs_excuse(scene, thing);
    printf("| %s | %s | %s %d | %s |\n", id, scene, light ? "light" : "object",
           light ? thing - SCENE_MAX_OBJECTS : thing,
           why[0]   ? why
           : excuse ? excuse
                    : "**nothing**");
    fflush(stdout);
}

// What no mistake needs waits for the changes.
static void tell_thing(SceneTable *table, const char *id, const char *scene, int thing, const char *why) {
    if (table->changes && !why[0] && !scene_needs_excuse(scene, thing)) {
        INVARIANT(table->needless_count < OBJECT_WORTH_MOST);
        table->needless[table->needless_count++] = (ObjectWorth){.scene = scene, .thing = thing};
    } else {
        print_thing(id, scene, thing, why);
    }
}

static void describe_worth(char why[POWER_TEXT], const LabChanges *changes, const ObjectWorth *worth) {
    char change[CHANGE_TEXT] = "";
    why[0] = '\0';
    if (worth->example >= 0)
        lab_changes_describe(change, changes, worth->example);
    for (char *at = change; *at; at++)
        *at = *at == '|' ? '/' : *at; // a table's cells end there
    if (worth->unfit)
        snprintf(why, POWER_TEXT, "a check would not be asked");
    else if (worth->killed > 0)
        snprintf(why, POWER_TEXT, "%d small changes would pass, as `%.200s`", worth->killed, change);
}

static bool print_worths(SceneTable *table, const char *id) {
    static LabChanges changes;
    const int processes = (int)sysconf(_SC_NPROCESSORS_ONLN);
    bool ok = table->needless_count == 0 ||
              (lab_changes_open(&changes, id) &&
               object_worth_find(&changes, table->needless, table->needless_count, 1, processes));
    for (int i = 0; ok && i < table->needless_count; i++) {
        char why[POWER_TEXT];
        describe_worth(why, &changes, &table->needless[i]);
        print_thing(id, table->needless[i].scene, table->needless[i].thing, why);
    }
    lab_changes_close(&changes);
    table->needless_count = 0;
    return ok;
}

// Over all seeds at most, until one needs one of the things; `why` says the seed, too.
static bool ask_seeds(Exam *exams[SEEDS], const char *scene, PowerThings things, char why[POWER_TEXT]) {
    bool ok = true;
    why[0] = '\0';
    for (int seed = 0; ok && seed < SEEDS && !why[0]; seed++) {
        ok = scene_power_find(exams[seed], scene, things, why);
        if (why[0])
            snprintf(why + strlen(why), POWER_TEXT - strlen(why), ", seed %d", seed + 1);
    }
    return ok;
}

// Which of the things may all go at once? One after the other goes, and comes back when something is decided
// otherwise without it.
static bool look_together(const char *id, Exam *exams[SEEDS], const char *scene, PowerThings things) {
    PowerThings gone = 0;
    bool ok = true;
    for (int thing = ECONOMY_THINGS - 1; ok && thing >= 0; thing--) {
        const PowerThings one = (PowerThings)1 << thing;
        char why[POWER_TEXT] = "", name[80];
        if (!(things & one))
            continue;
        ok = ask_seeds(exams, scene, gone | one, why);
        snprintf(name, sizeof name, "%s, %d others gone", scene, __builtin_popcount(gone));
        if (ok)
            print_thing(id, name, thing, why);
        gone |= why[0] ? 0 : one;
    }
    return ok;
}

static bool look_for_power(SceneTable *table, const char *id, const char *scene, Exam *exams[SEEDS]) {
    PowerThings needless = 0;
    bool ok = true;
    for (int thing = 0; ok && thing < ECONOMY_THINGS; thing++) {
        char why[POWER_TEXT];
        if (!scene_power_has(exams[0], scene, thing))
            continue;
        ok = ask_seeds(exams, scene, (PowerThings)1 << thing, why);
        if (ok && table->together)
            needless |= why[0] || scene_needs_excuse(scene, thing) ? 0 : (PowerThings)1 << thing;
        else if (ok)
            tell_thing(table, id, scene, thing, why);
    }
    return ok && look_together(id, exams, scene, needless);
}

static bool print_power(SceneTable *table, const char *id, const Rubric *rubric) {
    Painters painters = {.rubric = rubric, .client = table->worker};
    Exam *exams[SEEDS] = {0};
    bool ok = true;
    for (int seed = 0; ok && seed < SEEDS; seed++) {
        exams[seed] = calloc(1, sizeof *exams[seed]);
        ok = exams[seed] && exam_create(exams[seed], rubric, &painters, (uint64_t)seed + 1);
    }
    for (int i = 0; ok && scene_name(i); i++)
        ok = look_for_power(table, id, scene_name(i), exams);
    for (int seed = 0; seed < SEEDS; seed++) {
        if (exams[seed])
            exam_destroy(exams[seed]);
        free(exams[seed]);
    }
    table->worker = painters.client;
    painters.client = (WorkerClient){0}; // goes on
    painters_destroy(&painters);
    return ok;
}

static void print_lab(const char *id, void *context) {
    SceneTable *table = context;
    static SceneNeeds economies[ECONOMY_MAX_SCENES];
    char folder[FILES_PATH];
    Rubric rubric = {0};
    if (table->lab[0] && strcmp(table->lab, id) != 0)
        return;
    int count = table->broken || !places_find_lab(folder, id) || !rubric_load(&rubric, folder) ? -1
                : table->power ? (print_power(table, id, &rubric) && print_worths(table, id) ? 0 : -1)
                               : scene_needs_measure(economies, &rubric, &table->worker, SEEDS, 2);
    table->broken = count < 0;
    for (int i = 0; i < count; i++)
        print_row(id, &economies[i]);
    rubric_destroy(&rubric);
}

static const Option options[] = {
    {"lab", 0, "NN", "only this lab", offsetof(SceneTable, lab), option_lab},
    {"power", 0, NULL,
     "what each object of each scene is worth: the check that would let a mistake pass without it",
     offsetof(SceneTable, power), option_flag},
    {"together", 0, NULL, "with --power: which of those that no verdict needs may all go at once",
     offsetof(SceneTable, together), option_flag},
    {"changes", 0, NULL,
     "with --power: of what no known mistake needs, which small change of the solution would pass (minutes)",
     offsetof(SceneTable, changes), option_flag},
    {0}};

static bool check(void *settings, const Operands *operands) {
    const SceneTable *table = settings;
    (void)operands;
    return (table->power || (!table->changes && !table->together) ||
            check_fail("--changes and --together belong to --power")) &&
           (!table->changes || !table->together || check_fail("ask --changes and --together one at a time"));
}

static const CommandLine command_line = {
    .program = "scene_table",
    .forms = "[options]",
    .about =
        "Prints what each lab's scenes are made of, and how much the graded views need it, as a table.\n",
    .options = options,
    .check = check,
};

int main(int count, char **arguments) {
    static SceneTable table;
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, &table, count, arguments);
    command_line_settle_context(&command_line, &context);
    printf("%s", table.power
                     ? "| lab | scene | what | without it |\n|---|---|---|---|\n"
                     : "| lab | scene | planes | boxes | spheres | arches | triangles | least need, % |\n"
                       "|---|---|---|---|---|---|---|---|\n");
    table.broken = !places_list_labs(print_lab, &table) || table.broken;
    worker_client_stop(&table.worker);
    if (table.broken)
        fprintf(stderr, "scene_table: %s\n", check_message());
    return table.broken ? 3 : 0;
}
