#include "window/marks.h"

#include "window/counts.h"

#include <math.h>
#include <string.h>

static const Color bright = {255, 255, 255, 255}, ground = {12, 14, 18, 220}, accent = {255, 214, 90, 255};

static void put_name(Text *text, float x, float y, const char *name) {
    text_box(text, x, y, (float)(strlen(name) + 2) * text->advance, text->line * 1.2F, ground);
    text_put(text, x + text->advance, y + text->line * 0.1F, bright, name);
}

// A dark border lets the line be seen on any picture.
static void put_split(Text *text, const App *app, const Place *place, int height) {
    const char *other = app_other(app) == FEED_TRUTH ? "truth" : "reference";
    const float x = (float)place->x + roundf(app->state.split * (float)place->width),
                top = (float)(height - place->y - place->height), half = roundf(text->advance / 6),
                away = 2 * half + 2, left = 7 * text->advance; // the width of "yours" and its margins
    text_box(text, x - half - 1, top, 2 * half + 2, (float)place->height, ground);
    text_box(text, x - half, top, 2 * half, (float)place->height, accent);
    if (!app->state.text || (float)place->width < 30 * text->advance) // on a small picture they would hide it
        return;
    put_name(text, x - away - left, top + (float)place->height * 0.5F, "yours");
    put_name(text, x + away, top + (float)place->height * 0.5F, other);
}

static void put_legend(Text *text, int width, int height) {
    const float row = text->line, side = text->advance * 2, wide = 15 * text->advance;
    int count = 0;
    while (counts_color(count))
        count++;
    if (wide > (float)width / 3 || row * ((float)count + 1.5F) > (float)height) // it would hide the picture
        return;
    const float x = (float)width - wide, y = fmaxf(0, ((float)height - row * (float)(count + 1)) / 2);
    text_box(text, x, y, wide, row * ((float)count + 1.5F), ground);
    text_put(text, x + text->advance, y + row * 0.2F, bright, "volumes");
    for (int i = 0; i < count; i++) {
        const CountColor *color = counts_color(i);
        const Color shown = {color->shown[0], color->shown[1], color->shown[2], 255};
        const float at = y + row * ((float)i + 1.2F);
        text_box(text, x + text->advance, at + row * 0.1F, side, row * 0.7F, shown);
        text_put(text, x + text->advance * 2 + side, at, bright, color->name);
    }
}

void marks_put(Text *text, const App *app, const Place *place, int width, int height) {
    if (app->state.show == SHOW_SPLIT && place->width > 0)
        put_split(text, app, place, height);
    if (app->state.text && counts_is_view(app->drawn.view) && app->state.show != SHOW_DIFFERENCE)
        put_legend(text, width, height);
}
