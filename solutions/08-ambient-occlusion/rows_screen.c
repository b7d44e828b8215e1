// Ambient occlusion from the picture alone: it knows only what the camera sees.
#include "study_faster.h"
#include "scene/check.h"
#include "truth/closed_scenes.h"
#include "stability/row.h"

#include <math.h>

enum { SIZE = 160, BAKED = 0, SCREEN = 1, TRUTH_RAYS = 256, WALL = 0 };
static const float radius = 0.6f; // of the occlusion, by both methods

// Whatever the camera sees before a point hides it, as before task 8.9.
static const Change unlimited = {
    .name = "far occluders count",
    .edits = {{"ssao.frag", "return distance - seen < u_radius;", "return true;"}},
    .edit_count = 1};

// One frame of a method, with the truth beside it.
typedef struct Sky {
    TruthView truth_view;
    Measured measured;
} Sky;

static bool draw(Sky *sky, LabSet *labs, const Scene *scene, const Change *change, int method) {
    const TruthQuery query = {.kind = TRUTH_OCCLUSION, .samples = TRUTH_RAYS, .limit = radius};
    Setting setting = {.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
    *sky = (Sky){0};
    setting_knob(&setting, "method", (float)method);
    setting_knob(&setting, "ray length", radius);
    setting_knob(&setting, "rays", TRUTH_RAYS);
    LabArtist *artist = lab_set_artist(labs, LAB_ID, change);
    return artist && truth_view_create(&sky->truth_view, scene, (MetricsSize){SIZE, SIZE}, &query, artist) &&
           truth_view_measure(&sky->truth_view, artist, &setting, false, &sky->measured);
}

static void end(Sky *sky) {
    measured_destroy(&sky->measured);
    truth_view_destroy(&sky->truth_view);
}

// A floor and, to the left of it, a wall; the camera turns away from the wall by `pan` degrees. The point
// lies `near` the wall.
static const vec3s place = {{-1.75f, 0, 0}};

static Scene panned(double pan) {
    const vec3s eye = vec3_make(1.5f, 2, 0);
    Scene scene = {.camera = {.eye = eye, .fov_y = glm_rad(40), .near_plane = 0.5f, .far_plane = 20}};
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(2, 1, 2), 0);
    closed_stand(&scene, vec3_make(-2, 1, 0), 2, 1, 90);
    vec3s view = glms_vec3_rotate(glms_vec3_sub(place, eye), glm_rad((float)pan), vec3_make(0, 0, 1));
    scene.camera.target = glms_vec3_add(eye, view);
    return scene;
}

// What the picture shows at a place: of the four pixels around it.
static double seen_at(const Sky *sky, vec3s p) {
    const Camera *camera = &sky->truth_view.truth.scene.camera;
    mat4s clip_from_world = glms_mat4_mul(camera_clip_from_view(camera, 1), camera_view_from_world(camera));
    vec4s clip = glms_mat4_mulv(clip_from_world, glms_vec4(p, 1));
    float x = (clip.x / clip.w + 1) * SIZE / 2 - 0.5f, y = (1 - clip.y / clip.w) * SIZE / 2 - 0.5f, sum = 0;
    for (int i = 0; i < 4; i++) {
        int column = (int)floorf(x) + i % 2, row = (int)floorf(y) + i / 2;
        float share_x = i % 2 ? x - floorf(x) : 1 - (x - floorf(x)),
              share_y = i / 2 ? y - floorf(y) : 1 - (y - floorf(y));
        sum += share_x * share_y * sky->measured.visibility[row * SIZE + column];
    }
    return sum;
}

// Adds how far the point has been from what it shows in the middle of the picture, at most so far. A baked
// value is interpolated on the way: between texels, pixels, and the 255 steps of a picture.
static bool sweep_pan(LabSet *labs, Findings *findings, Curve *curve, const Change *change, int method) {
    double first = 0, most = 0;
    bool ok = true;
    for (int pan = 0; ok && pan <= 18; pan += 2) {
        const Scene scene = panned(pan);
        Sky sky;
        ok = draw(&sky, labs, &scene, change, method);
        if (ok) {
            double seen = seen_at(&sky, place);
            first = pan == 0 ? seen : first;
            most = fmax(most, fabs(seen - first));
            curve_add(curve, pan, most, 0, 2.0 / 255);
            findings_frame(findings, method, pan, &sky.truth_view, &sky.measured, "%s, turned by %d degrees",
                           method == BAKED ? "Baked" : "From the picture", pan);
        }
        end(&sky);
    }
    return ok;
}

// A wall straight on, and a thin post before it.
static Scene wall_and_post(double distance) {
    Scene scene = closed_wall(3, 10, glm_rad(30));
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, (float)distance), vec3_make(0.1f, 1.5f, 0.1f), 0);
    return scene;
}

// Mean false shadow on what is seen of the wall; without the post, the wall is all white.
static double halo(const Sky *sky) {
    double dark = 0, count = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        if (sky->measured.mask[i] && sky->truth_view.picture.hits[i].object == WALL) {
            dark += 1 - sky->measured.visibility[i];
            count++;
        }
    return dark / count;
}

// `least`: what must show at least.
static bool sweep_post(LabSet *labs, Findings *findings, Curve *curve, const Change *change, int method,
                       double least) {
    bool ok = true;
    for (int i = 5; ok && i <= 12; i++) {
        double distance = radius * i / 4.0;
        const Scene scene = wall_and_post(distance);
        Sky sky;
        ok = draw(&sky, labs, &scene, change, method);
        if (ok) {
            curve_add(curve, distance / radius, halo(&sky), least, 0);
            if (least > 0)
                findings_frame(findings, 2, halo(&sky), &sky.truth_view, &sky.measured,
                               "From the picture without a limit, a post %.2f radii before the wall",
                               distance / radius);
        }
        end(&sky);
    }
    return ok;
}

static bool run_screen(LabSet *labs, Findings *findings) {
    Figure *pan = findings_figure(findings, "The camera turns down from a wall", "turn (degrees)",
                                  "change at one point (visibility)"),
           *post = findings_figure(findings, "A post before a wall", "distance from the wall (radii)",
                                   "false shadow on the wall (share)");
    return sweep_pan(labs, findings, figure_curve(pan, "failure: screen space", CURVE_RISING), NULL,
                     SCREEN) &&
           sweep_pan(labs, findings, figure_curve(pan, "failure: two factors", CURVE_RISING),
                     &occlusion_two_factors, SCREEN) &&
           sweep_pan(labs, findings, figure_curve(pan, "failure: half size", CURVE_RISING),
                     &occlusion_half_size, SCREEN) &&
           sweep_pan(labs, findings, figure_curve(pan, "remedy: baked", CURVE_EQUAL), NULL, BAKED) &&
           sweep_post(labs, findings, figure_curve(post, "failure: no limit", CURVE_LEAST), &unlimited,
                      SCREEN, 1.0 / 255) &&
           sweep_post(labs, findings, figure_curve(post, "remedy: a limit", CURVE_EQUAL), NULL, SCREEN, 0) &&
           sweep_post(labs, findings, figure_curve(post, "a limit, two factors", CURVE_EQUAL),
                      &occlusion_two_factors, SCREEN, 0) &&
           sweep_post(labs, findings, figure_curve(post, "a limit, half size", CURVE_EQUAL),
                      &occlusion_half_size, SCREEN, 0) &&
           sweep_post(labs, findings, figure_curve(post, "remedy: baked", CURVE_EQUAL), NULL, BAKED, 0);
}

const Row LAB_TABLE[] = {
    {29, "screen-space occlusion", "ambient occlusion from the picture",
     "the camera turns by 0 to 18 degrees; a post 1.25 to 3 radii before a wall",
     "What leaves the picture occludes no more: a place beside a wall gets brighter as the wall leaves the "
     "picture. And what the camera sees before a surface seems to touch it: a post throws a halo on a "
     "wall far behind, unless a limit leaves out what is farther away than the radius. Baked values know "
     "neither.",
     "baked values; rays shorter than the distance", run_screen},
    {0},
};
