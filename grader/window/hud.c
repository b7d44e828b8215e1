// Writes each block of text: state and knobs, times, the pixel under the mouse, problems; over it the table
// of keys.
#include "window/hud.h"

#include "scene/check.h"
#include "window/counts.h"
#include "window/help.h"
#include "window/knob_step.h"
#include "window/lines.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const Color white = {255, 255, 255, 255}, dim = {186, 192, 200, 255}, accent = {255, 214, 90, 255};
static const Color panel = {12, 14, 18, 196}, alarm = {112, 20, 24, 232};
static const char *const names[FEED_COUNT] = {"mine", "reference", "truth"};
static const double PATIENCE = 1;                          // seconds until the text says that a frame is late
static const float MOST_TEXT = 0.45F, MOST_PROBLEM = 0.6F; // of the window's area, of its height

// How much is written: in a small window the least important goes first, so that the picture is seen.
typedef enum Detail { NO_DETAIL, KEYS, TITLE, KNOB, VERDICT, KNOBS, STATE, TIMES, PIXEL, ALL_DETAIL } Detail;

static const char *show_name(const ViewState *state) {
    static const char *const shows[2][SHOW_COUNT] = {
        {"mine", "reference", "mine | reference", "difference to the reference", "truth"},
        {"mine", "reference", "mine | truth", "difference to the truth", "truth"}};
    return shows[state->against_truth][state->show];
}

static void add_knob(const App *app, int i, Lines *lines) {
    char value[2 * PROTOCOL_LINE], line[LINES_LENGTH] = "";
    const struct KnobText *knob = &app->table.knobs[i];
    bool selected = i == app->state.selected;
    knob_text(knob, view_state_knob(&app->state, knob), value, sizeof value);
    check_append(line, sizeof line, "%c %-14s %s", selected ? '>' : ' ', knob->name, value);
    lines_add(lines, selected ? accent : white, line);
}

// To what the truth sends its rays.
static void tell_truth(const App *app, char *line, size_t size) {
    const Scene *scene = &app->drawn.scene;
    float extent = 0;
    for (int i = 0; i < scene->light_count; i++)
        extent = fmaxf(extent, scene->lights[i].extent);
    if (scene->medium.scattering > 0)
        check_append(line, size, "rays through the dust: what it sends to the eye");
    else if (strcmp(app_truth_view(app), VIEW_OCCLUSION) == 0)
        check_append(line, size, "rays to the sky: how much of it each point sees");
    else if (extent > 0)
        check_append(line, size, "rays to the lamp, a square of %.2g: how much of it each point sees",
                     (double)(2 * extent));
    else
        check_append(line, size, "a ray to each light; they have no size, so edges are hard");
}

// What the view shows, and of a stage how large it is.
static void add_caption(const App *app, Lines *lines) {
    const FrameFacts *facts = &app->news[FEED_MINE].facts;
    const char *caption = captions_find(&app->captions, app->state.view);
    char line[LINES_LENGTH] = "";
    if (view_state_needs_truth(&app->state))
        tell_truth(app, line, sizeof line);
    else
        check_append(line, sizeof line, "%s", caption);
    if (line[0] && facts->stage_width > 0 && facts->stage_height > 0 && !view_state_needs_truth(&app->state))
        check_append(line, sizeof line, " (%d x %d)", facts->stage_width, facts->stage_height);
    lines_add(lines, dim, line);
}

static void add_shown(const App *app, Lines *lines) {
    char line[LINES_LENGTH] = "", what[LINES_LENGTH] = "";
    view_state_text(&app->state, &app->rubric, what, sizeof what);
    check_append(line, sizeof line, "%s: %s", show_name(&app->state), what);
    if (app_recorded_shows(app))
        check_append(line, sizeof line, "  [recorded: check %s, %s]",
                     app->rubric.checks[app->recorded.check].task,
                     app->rubric.checks[app->recorded.check].name);
    lines_add(lines, dim, line);
}

static void add_state(const App *app, Detail detail, Lines *lines) {
    char title[LINES_LENGTH] = "";
    check_append(title, sizeof title, "%s  %s", app->rubric.id, app_title(app));
    if (detail >= TITLE)
        lines_add(lines, white, title);
    if (detail >= STATE) {
        add_shown(app, lines);
        add_caption(app, lines);
    }
    for (int i = 0; i < app->table.knob_count; i++)
        if (detail >= KNOBS || (detail >= KNOB && i == app->state.selected))
            add_knob(app, i, lines);
}

// "mine        12.3 ms  (shadow map 2.1, picture 10.2)": CPU times of the passes; the sum is without those
// that only show something.
static void add_times(const App *app, FeedKind kind, Lines *lines) {
    const FeedNews *news = &app->news[kind];
    const Description *table = &news->description;
    char line[LINES_LENGTH] = "";
    float sum = 0;
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        sum += table->pass_kinds[i] == PASS_SHOW ? 0 : news->milliseconds[i];
    if (news->pictures == 0 || (kind == FEED_TRUTH && !view_state_needs_truth(&app->state)))
        return;
    check_append(line, sizeof line, "%-10s %6.1f ms", names[kind], (double)sum);
    for (int i = 0; i < table->pass_count && table->pass_count > 1; i++)
        check_append(line, sizeof line, "%s%s %.1f", i ? ", " : "  (", table->passes[i],
                     (double)news->milliseconds[i]);
    lines_add(lines, dim, table->pass_count > 1 ? strcat(line, ")") : line);
}

static void add_pixel(const App *app, const int cursor[2], Lines *lines) {
    char line[LINES_LENGTH] = "";
    const FeedKind kinds[2] = {FEED_MINE, app_other(app)};
    for (int i = 0; i < 2; i++) {
        const Image *image = &app->pictures[kinds[i]];
        if (cursor[0] < 0 || cursor[1] < 0 || cursor[0] >= image->width || cursor[1] >= image->height)
            continue;
        const uint8_t *at = image->rgba + image_at(image, cursor[0], cursor[1]);
        const CountColor *count = counts_is_view(app->drawn.view) ? counts_find(at) : NULL;
        if (!line[0])
            check_append(line, sizeof line, "pixel %d, %d:", cursor[0], cursor[1]);
        if (count)
            check_append(line, sizeof line, "  %s counts %s", names[kinds[i]], count->name);
        else
            check_append(line, sizeof line, "  %s %d %d %d", names[kinds[i]], at[0], at[1], at[2]);
    }
    lines_add(lines, dim, line);
}

static void add_difference(const App *app, Lines *lines) {
    const Difference *difference = &app->difference;
    double percent = app->composed.width * (double)app->composed.height / 100;
    char line[LINES_LENGTH] = "";
    if (app->state.show != SHOW_DIFFERENCE || percent <= 0)
        return;
    if (difference->brighter + difference->darker + difference->other == 0)
        check_append(line, sizeof line, "no pixel differs");
    else
        check_append(line, sizeof line,
                     "%% of pixels: %.2f too bright (yellow), %.2f too dark (blue), %.2f other colour",
                     (double)difference->brighter / percent, (double)difference->darker / percent,
                     (double)difference->other / percent);
    lines_add(lines, accent, line);
}

static void add_late(const App *app, FeedKind kind, Lines *lines) {
    const FeedNews *news = &app->news[kind];
    char line[LINES_LENGTH] = "";
    double late = news->busy_since > 0 ? process_now() - news->busy_since : 0;
    if (late < PATIENCE)
        return;
    check_append(line, sizeof line, "%s: %s for %.0f s", names[kind],
                 news->building ? "compiling" : "drawing", late);
    if (kind == FEED_MINE && !news->building)
        check_append(line, sizeof line, "; it is stopped after %.0f s", app->options->seconds);
    lines_add(lines, accent, line);
}

// What is wrong with mine, or with the other one that is looked at.
static void add_problems(const App *app, Lines *lines) {
    for (FeedKind kind = 0; kind < FEED_COUNT; kind++) {
        const FeedNews *news = &app->news[kind];
        char line[LINES_LENGTH] = "";
        if (kind != FEED_MINE && kind != app_other(app))
            continue;
        if (news->problem[0]) {
            check_append(line, sizeof line, "%s: %s", names[kind],
                         news->dead       ? "stopped; it starts again when you save, or with F5"
                         : news->outdated ? "the newest files do not work; this is what drew before"
                                          : "not drawn");
            lines_add(lines, accent, line);
        }
        lines_add(lines, white, news->problem);
        add_late(app, kind, lines);
    }
}

static int columns_of(const Text *text, int width) {
    return (int)((float)width / text->advance) - 2;
}

static void add_results(const App *app, Detail detail, const int cursor[2], Lines *lines) {
    lines_add(lines, accent, process_now() < app->notice_until ? app->notice : "");
    if (detail >= VERDICT) {
        lines_add(lines, accent, app->news[FEED_MINE].warning);
        lines_add(lines, accent, app->verdict);
    }
    add_difference(app, lines);
    for (FeedKind kind = 0; kind < FEED_COUNT && detail >= TIMES; kind++)
        add_times(app, kind, lines);
    if (detail >= PIXEL)
        add_pixel(app, cursor, lines);
    if (detail >= KEYS)
        lines_add(lines, dim, "F1 keys");
}

// The most detail that leaves enough of the picture.
static void fill(const App *app, const Text *text, float most, const int cursor[2], Lines *top,
                 Lines *bottom) {
    for (Detail detail = ALL_DETAIL;; detail--) {
        lines_clear(top);
        lines_clear(bottom);
        add_state(app, detail, top);
        add_results(app, detail, cursor, bottom);
        if (detail == NO_DETAIL || lines_area(top, text) + lines_area(bottom, text) <= most)
            return;
    }
}

void hud_put(Text *text, const App *app, int width, int height, const int cursor[2]) {
    static Lines top, bottom, problems;
    const float across = (float)width, down = (float)height;
    memset(&top, 0, sizeof top);
    memset(&bottom, 0, sizeof bottom);
    memset(&problems, 0, sizeof problems);
    top.columns = bottom.columns = problems.columns = columns_of(text, width);
    add_problems(app, &problems);
    lines_keep(&problems, (int)(MOST_PROBLEM * down / text->line), accent,
               "... all of it is in the terminal");
    if (app->state.text)
        fill(app, text, MOST_TEXT * across * down, cursor, &top, &bottom);
    float y = down - lines_height(&bottom, text);
    lines_put(&problems, text, 0, fmaxf(0, y - lines_height(&problems, text)), alarm);
    lines_put(&bottom, text, 0, y, panel);
    lines_put(&top, text, 0, 0, panel);
    if (app->state.help > 0)
        help_put(text, width, height, app->state.help);
}

void hud_title(const App *app, char *title, size_t size) {
    char what[LINES_LENGTH], value[2 * PROTOCOL_LINE];
    view_state_text(&app->state, &app->rubric, what, sizeof what);
    title[0] = '\0';
    check_append(title, size, "%s %s - %s: %s", app->rubric.id, app_title(app), show_name(&app->state), what);
    if (app->state.selected < app->table.knob_count) {
        const struct KnobText *knob = &app->table.knobs[app->state.selected];
        knob_text(knob, view_state_knob(&app->state, knob), value, sizeof value);
        check_append(title, size, " - %s %s", knob->name, value);
    }
}
