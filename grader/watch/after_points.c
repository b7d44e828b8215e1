#include "watch/after_points.h"

#include "base/places.h"
#include "points/own_table.h"
#include "points/recorded_study.h"
#include "scene/check.h"

#include <stdio.h>
#include <sys/stat.h>

enum { SCENES = 3, LINE = 400 };

static void show_best(Sheet *sheet, const OwnRow *row) {
    char text[LINE];
    snprintf(text, sizeof text,
             "your most accurate: %s, %s: %.3g %% in %.3g ms (our solution: %.3g %% in %.3g ms)", row->method,
             row->setting, 100 * row->error, row->milliseconds, 100 * row->our_error, row->our_milliseconds);
    sheet_text(sheet, STYLE_PLAIN, 5, text);
}

static void show_quicker(Sheet *sheet, const OwnRow *row) {
    char text[LINE];
    snprintf(text, sizeof text, "in at most half of that time: %s, %s: %.3g %% in %.3g ms", row->method,
             row->setting, 100 * row->our_error, row->our_milliseconds);
    sheet_text(sheet, STYLE_PLAIN, 5, text);
}

static void show_scene(Sheet *sheet, const OwnTable *table, int row) {
    const int best = own_table_best(table, row), quicker = own_table_quicker(table, row, best);
    sheet_text(sheet, STYLE_BOLD, 2, table->rows[row].title);
    show_best(sheet, &table->rows[best]);
    if (quicker >= 0)
        show_quicker(sheet, &table->rows[quicker]);
}

// Was a file of the lab saved after the numbers?
static bool is_old(const Rubric *rubric, const char *folder, const char *numbers) {
    struct stat then, file;
    char path[FILES_PATH];
    if (stat(numbers, &then) != 0)
        return false;
    for (int i = 0; i < rubric->file_count; i++) {
        files_join(path, folder, rubric->files[i]);
        if (stat(path, &file) == 0 && file.st_mtime > then.st_mtime)
            return true;
    }
    return false;
}

static void show_table(Sheet *sheet, const OwnTable *table, const Rubric *rubric, bool old) {
    int shown = 0;
    for (int row = 0; row < table->count && shown < SCENES; row = own_table_next_scene(table, row), shown++)
        show_scene(sheet, table, row);
    sheet_wrapped(sheet, STYLE_PLAIN, 2, "The chart, with all settings: build/study-%s.html%s", rubric->id,
                  old ? " (older than your files: make study again)" : "");
}

static void show_head(Sheet *sheet) {
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
    sheet_line(sheet, STYLE_BOLD, "%s", "Your methods: error against time");
}

void after_points_show(Sheet *sheet, const Rubric *rubric, const char *folder) {
    char name[32], numbers[FILES_PATH], index[FILES_PATH];
    OwnTable table = {0};
    snprintf(name, sizeof name, "study-%s.csv", rubric->id);
    places_build_path(numbers, name);
    recorded_study_index(index, rubric->folder);
    if (own_table_read(&table, numbers) && table.count > 0) {
        show_head(sheet);
        show_table(sheet, &table, rubric, is_old(rubric, folder, numbers));
    } else if (files_exists(index)) {
        show_head(sheet);
        sheet_wrapped(sheet, STYLE_PLAIN, 2,
                      "`make study LAB=%s SUBMISSION=labs` measures them and charts them beside ours.",
                      rubric->id);
    }
    own_table_destroy(&table);
    check_clear();
}
