// Writes the standings: lines, a page, and a key in results.json.
#include "compete/board.h"

#include "base/files.h"
#include "base/printable.h"
#include "pages/page.h"
#include "scene/check.h"

#include <math.h>
#include <stdlib.h>

enum { NAME_LEAST = 24, NAME_MOST = 40 }; // columns of a name in a terminal

static double percent(double share) {
    return round(1e4 * share) / 100;
}

// A name, filled up to a column in which what follows it stands.
static void print_name(const char *name, int width, FILE *out) {
    fprintf(out, "%s%*s", name, width > printable_columns(name) ? width - printable_columns(name) : 0, "");
}

static int name_width(const Standing *standings, int count) {
    int width = NAME_LEAST;
    for (int i = 0; i < count; i++)
        width = printable_columns(standings[i].name) > width ? printable_columns(standings[i].name) : width;
    return width < NAME_MOST ? width : NAME_MOST;
}

static void print_ranked(const Standing *standing, int width, FILE *out) {
    fprintf(out, "%3d  ", standing->place);
    print_name(standing->name, width, out);
    fprintf(out, " %8.1f a pixel: %.1f reads, %.1f fragments, %.1f texels; error %.2f %% at %s%s%s\n",
            standing->cost, standing->taps, standing->fragments, standing->texels, percent(standing->error),
            standing->setting, standing->note[0] ? "; ! " : "", standing->note);
}

void board_print(const Standing *standings, int count, const Arena *arena, FILE *out) {
    const int width = name_width(standings, count);
    fprintf(out, "Lab %s: the cost of a method that errs at most %.2f %% (scene \"%s\", %d hidden cameras)\n",
            arena->lab, percent(arena->most_error), arena->scene, ARENA_CAMERAS);
    for (int i = 0; i < count; i++) {
        if (standings[i].ranked) {
            print_ranked(&standings[i], width, out);
        } else {
            fprintf(out, "  -  ");
            print_name(standings[i].name, width, out);
            fprintf(out, " not ranked: %s\n", standings[i].reason);
        }
    }
    if (count == 0)
        fprintf(out, "  nobody has handed in yet\n");
}

static void write_number(Page *page, const char *format, double value) {
    fputs("<td class=\"number\">", page->out);
    fprintf(page->out, format, value);
    fputs("</td>", page->out);
}

static void write_cell(Page *page, const char *class_name, const char *text) {
    fprintf(page->out, "<td class=\"%s\">", class_name);
    page_text(page, text);
    fputs("</td>", page->out);
}

static void write_nobody(Page *page, int count) {
    fprintf(page->out, "<p><strong>Nobody is ranked yet.</strong> %s</p>\n",
            count == 0
                ? "Nobody has handed in."
                : "Below stands of each hand-in why it is not: it must pass all checks of the lab, and then "
                  "draw this scene with few enough errors, by a shadow map.");
}

static void write_ranked(Page *page, const Standing *standings, int count) {
    bool noted = false;
    for (int i = 0; i < count && standings[i].ranked; i++)
        noted = noted || standings[i].note[0];
    const char *const heads[] = {"#place",    "student",    "#cost",
                                 "#reads",    "#fragments", "#texels",
                                 "#error, %", "setting",    noted ? "look at" : NULL,
                                 NULL};
    page_begin_table(page, "Who is ranked", heads);
    for (int i = 0; i < count && standings[i].ranked; i++) {
        const Standing *standing = &standings[i];
        fputs("<tr>", page->out);
        write_number(page, "%.0f", standing->place);
        write_cell(page, "name", standing->name);
        write_number(page, "%.1f", standing->cost);
        write_number(page, "%.1f", standing->taps);
        write_number(page, "%.1f", standing->fragments);
        write_number(page, "%.1f", standing->texels);
        write_number(page, "%.2f", percent(standing->error));
        write_cell(page, "words", standing->setting);
        if (noted)
            write_cell(page, "words", standing->note);
        fputs("</tr>\n", page->out);
    }
    page_end_table(page);
}

static void write_others(Page *page, const Standing *standings, int count) {
    static const char *const heads[] = {"student", "why", NULL};
    int i = 0;
    while (i < count && standings[i].ranked)
        i++;
    if (i == count)
        return;
    fputs("<h2>Not ranked</h2>\n", page->out);
    page_begin_table(page, "Who is not ranked", heads);
    for (; i < count; i++) {
        fputs("<tr>", page->out);
        write_cell(page, "name", standings[i].name);
        write_cell(page, "words", standings[i].reason);
        fputs("</tr>\n", page->out);
    }
    page_end_table(page);
}

char *board_page(const Standing *standings, int count, const Arena *arena) {
    Page page = {0};
    char title[ARENA_TEXT];
    snprintf(title, sizeof title, "Lab %s: the contest", arena->lab);
    if (!page_begin(&page, title))
        return NULL;
    fprintf(page.out,
            "<p>What a method costs a pixel, without times: reads of textures, shaded fragments and cleared "
            "texels, the mean of %d hidden cameras. Who passes the lab takes part; of the settings that err "
            "at most %.2f %% the cheapest counts.</p>\n",
            ARENA_CAMERAS, percent(arena->most_error));
    if (count > 0 && standings[0].ranked)
        write_ranked(&page, standings, count);
    else
        write_nobody(&page, count);
    write_others(&page, standings, count);
    return page_end(&page);
}

static void add_reason(json_t *results, const char *reason) {
    const char *said = json_string_value(json_object_get(results, "output"));
    json_object_set_new(results, "output",
                        json_sprintf("%sNot on the leaderboard: %s\n", said ? said : "", reason));
}

static json_t *leaderboard(const Standing *standing) {
    return json_pack("[{s:s, s:f, s:s}, {s:s, s:f, s:s}, {s:s, s:s}]", "name", "cost a pixel", "value",
                     standing->cost, "order", "asc", "name", "error, %", "value", percent(standing->error),
                     "order", "asc", "name", "setting", "value", standing->setting);
}

bool board_add_to_results(const Standing *standing, const char *path) {
    json_t *results = json_load_file(path, 0, NULL);
    if (!json_is_object(results)) {
        json_decref(results);
        return check_fail("%s holds no results of build/grade --format gradescope", path);
    }
    if (standing->ranked)
        json_object_set_new(results, "leaderboard", leaderboard(standing));
    else
        add_reason(results, standing->reason);
    char *text = json_dumps(results, JSON_INDENT(2));
    const bool ok = text && files_write_whole(path, text, true);
    free(text);
    json_decref(results);
    return ok;
}
