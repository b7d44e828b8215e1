// scene_table: what each lab's scenes are made of, and how much the graded views need it; prints a table
// (Markdown, for grader/proof/SCENES.md).
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "proof/scene_needs.h"
#include "base/command_line.h"
#include "base/places.h"

#include <signal.h>
#include <stdio.h>

enum { SEEDS = 4 };

typedef struct SceneTable {
    WorkerClient worker; // draws all labs
    bool broken;
} SceneTable;

static void print_row(const char *id, const SceneNeeds *economy) {
    char text[ECONOMY_TEXT];
    scene_needs_describe(text, id, economy);
    printf("%s %.1f |\n", text, 100 * scene_needs_least(economy));
}

static void print_lab(const char *id, void *context) {
    SceneTable *table = context;
    static SceneNeeds economies[ECONOMY_MAX_SCENES];
    char folder[FILES_PATH];
    Rubric rubric = {0};
    int count = table->broken || !places_find_lab(folder, id) || !rubric_load(&rubric, folder)
                    ? -1
                    : scene_needs_measure(economies, &rubric, &table->worker, SEEDS, 2);
    table->broken = count < 0;
    for (int i = 0; i < count; i++)
        print_row(id, &economies[i]);
    rubric_destroy(&rubric);
}

static const CommandLine command_line = {
    .program = "scene_table",
    .forms = "",
    .about =
        "Prints what each lab's scenes are made of, and how much the graded views need it, as a table.\n",
    .options = (const Option[]){{0}},
};

int main(int count, char **arguments) {
    SceneTable table = {0};
    command_line_take(&command_line, NULL, count, arguments);
    signal(SIGPIPE, SIG_IGN);
    printf("| lab | scene | planes | boxes | spheres | arches | triangles | least need, %% |\n");
    printf("|---|---|---|---|---|---|---|---|\n");
    table.broken = !places_list_labs(print_lab, &table) || table.broken;
    worker_client_stop(&table.worker);
    if (table.broken)
        fprintf(stderr, "scene_table: %s\n", check_message());
    return table.broken ? 3 : 0;
}
