// A ball rolls on: its shadow must go with it, and none may stay in the light map.
#include "scene/count.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <math.h>

enum { SIDE = 240 };
static const double radius = 0.3, height = 1;

static const Change baked_in = {
    .name = "what moves is baked",
    .edits = {{"luxels.h", "moves(&scene->objects[i]) != moving", "moving && !moves(&scene->objects[i])"}},
    .edit_count = 1};

// A ball before a wall, under a sun from above.
static Scene wall_and_ball(double x) {
    Scene scene = closed_wall(2, 10, 2 * atanf(0.2f));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 6, 6), vec3_make(0, 0, 0), 0, 3, 1, 20);
    float r = (float)radius;
    closed_add(&scene, SHAPE_SPHERE, vec3_make((float)x, 0, (float)height), vec3_make(r, r, r), 0);
    return scene;
}

// Is a place of the wall in the shadow of a ball at x, made larger by `margin`? The shadow of a sun 45
// degrees high is an ellipse, r wide and sqrt(2) r high, its middle as far down as the ball is from the wall.
static bool is_dark(double x, double at_x, double at_y, double margin) {
    return hypot(at_x - x, (at_y + height) / sqrt(2)) < radius + margin;
}

// The dark area of the wall outside of the ball's true shadow: what the camera sees of it.
static double false_area(const Image *image, double x, double pixel, double texel) {
    double area = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double at_x = (i % SIDE + 0.5 - SIDE / 2.0) * pixel,
               at_y = (SIDE / 2.0 - 0.5 - floor((double)i / SIDE)) * pixel;
        double scale = (10 - height) / 10; // to where the way to the eye passes the ball
        bool is_ball = hypot(at_x * scale - x, at_y * scale) < radius + 2 * pixel;
        if (!is_ball && !is_dark(x, at_x, at_y, 2 * texel))
            area += pixel * pixel * (1 - image->rgba[4 * i] / 255.0);
    }
    return area;
}

// Draws the ball at one place after the other with the same lab.
static bool roll(LabSet *labs, Curve *curve, const Change *change, double first) {
    static Reply reply;
    const double places[] = {first, first + 0.7, first + 1.2, first + 1.9, first + 2.6};
    Setting setting = {.view = VIEW_VISIBILITY};
    setting_knob(&setting, "luxel density", 12);
    setting_knob(&setting, "map size", 1024);
    LabArtist *artist = lab_set_artist(labs, LAB_ID, change);
    bool ok = artist != NULL;
    for (size_t i = 0; ok && i < COUNT(places); i++) {
        const Scene scene = wall_and_ball(places[i]);
        const Request request = setting_request(&setting, &scene, (MetricsSize){SIDE, SIDE});
        double pixel = closed_unit(&scene, SIDE), texel = 6.0 / 1024, luxel = 1 / 12.0;
        Image image = {0};
        ok = lab_artist_draw(artist, &request, &image, &reply);
        // The ellipse's area; along its outline, 2 pi sqrt((a^2 + b^2) / 2) long,
        // half a luxel at most is wrong.
        double stays = i > 0 && change ? GLM_PI * radius * radius * sqrt(2) : 0;
        double outline = 2 * GLM_PI * radius * sqrt(1.5);
        if (ok)
            curve_add(curve, places[i] - first, false_area(&image, places[i], pixel, texel), stays,
                      change ? outline * luxel / 2 : 0);
        image_destroy(&image);
    }
    return ok;
}

static bool run_moving(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A ball rolls past a wall", "way of the ball (units)",
                                     "false shadow (square units)");
    return roll(labs, figure_curve(figure, "only what stands still is baked", CURVE_EQUAL), NULL, -1.3) &&
           roll(labs, figure_curve(figure, "failure: the ball is baked", CURVE_EQUAL), &baked_in, -1.3);
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "what moves is not baked", "a light map, and the shadow map of a ball",
     "a ball that rolls",
     "The light map is made once. A ball that was in it leaves its shadow behind: a false shadow of "
     "pi r^2 sqrt(2) under a sun 45 degrees high. What is baked without the ball, and multiplied by the "
     "ball's own shadow map, is right wherever the ball is.",
     "closed form", run_moving},
    {0},
};
