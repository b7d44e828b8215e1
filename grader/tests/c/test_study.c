// The study's arithmetic against values worked out by hand: medians, the front, edges, what is kept.
#include "study/pareto.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/statistics.h"
#include "truth/closed_scenes.h"
#include "study/findings_csv.h"
#include "study/edge.h"
#include "study/measurements.h"
#include "study/views.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

// Of 1 2 4 8 100 the median is 4, the deviations are 3 2 0 4 96. Of 1 2 3 10 it is 2.5, the deviations
// are 1.5 0.5 0.5 7.5.
static void test_median(void **unused) {
    (void)unused;
    double odd[2][5] = {{100, 2, 8, 1, 4}, {100, 2, 8, 1, 4}}, even[2][4] = {{10, 1, 3, 2}, {10, 1, 3, 2}};
    assert_true(statistics_median(odd[0], 5) == 4 && statistics_mad(odd[1], 5) == 3);
    assert_true(statistics_median(even[0], 4) == 2.5 && statistics_mad(even[1], 4) == 1);
    assert_true(statistics_median((double[]){7}, 1) == 7 && statistics_mad((double[]){7}, 1) == 0);
}

static void test_front(void **unused) {
    (void)unused;
    Point points[] = {
        {10, 1, 0.1, false, false},      // fastest
        {20, 1, 0.01, false, false},     // the next step of the front
        {25, 1, 0.02, false, false},     // slower and worse than the second
        {21, 1, 0.01, false, false},     // as good as the second, and slower within the noise only
        {30, 1, 0.01, false, false},     // as good as the second, and surely slower
        {20.5, 1, 0.0101, false, false}, // slower and worse than the second, both within the noise
        {40, 1, 0.001, false, false},    // most accurate
        {0.1, 0, 0, false, true},        // aside
        {-1, 0, 0, false, false}};       // did not draw
    const bool expected[] = {true, true, false, true, false, true, true, false, false};
    pareto_mark(points, 9);
    for (int i = 0; i < 9; i++)
        assert_int_equal(points[i].on_front, expected[i]);
    assert_false(pareto_dominates(&points[0], &points[0]));
    assert_true(pareto_surely_faster(&points[0], &points[1]) &&
                !pareto_surely_faster(&points[1], &points[3]));
}

enum { SIDE = 20 };

typedef struct Picture {
    int32_t traced[SIDE * SIDE];
    uint8_t mask[SIDE * SIDE];
    float truth[SIDE * SIDE], measured[SIDE * SIDE], distance[SIDE * SIDE];
} Picture;

// One object, all of it counted, lit where u * x + v * y >= 10 (the method: >= 10 + off).
static Picture make_picture(int u, int v, int off) {
    Picture picture;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int place = u * (i % SIDE) + v * (i / SIDE);
        picture.traced[i] = 0;
        picture.mask[i] = 1;
        picture.truth[i] = place >= 10;
        picture.measured[i] = place >= 10 + off;
    }
    return picture;
}

// A vertical edge through 20 rows runs over 19 squares between pixels.
static void test_edge_length(void **unused) {
    (void)unused;
    const MetricsSize size = {SIDE, SIDE};
    Picture upright = make_picture(1, 0, 0);
    assert_true(fabs(edge_length(size, upright.traced, upright.mask, upright.truth) - 19) < 1e-9);
    upright.mask[5 * SIDE + 9] = 0; // two squares touch it
    assert_true(fabs(edge_length(size, upright.traced, upright.mask, upright.truth) - 17) < 1e-9);
    for (int i = 0; i < SIDE * SIDE; i++)
        upright.traced[i] = metrics_primitive(i % SIDE >= 10, 0); // the edge is where one object ends
    assert_true(edge_length(size, upright.traced, upright.mask, upright.truth) == 0);
}

enum { WIDE = 120, BORDER = 10, PARTS = 8 };

// The share of a pixel on one side of the line n . p = d, of 8 x 8 places.
static float covered(const double n[2], double d, int x, int y) {
    int lit = 0;
    for (int i = 0; i < PARTS * PARTS; i++)
        lit +=
            n[0] * (x + (i % PARTS + 0.5) / PARTS) + n[1] * (y + ((i - i % PARTS) / PARTS + 0.5) / PARTS) >=
            d;
    return (float)lit / (PARTS * PARTS);
}

// Straight edges at all angles, through the middle of a picture of which the inner part counts: at the angle
// t the line's part in a square of side s is s / max(|cos t|, |sin t|).
static void test_edge_angles(void **unused) {
    (void)unused;
    static int32_t traced[WIDE * WIDE];
    static uint8_t mask[WIDE * WIDE];
    static float truth[WIDE * WIDE];
    for (int degrees = 0; degrees < 180; degrees++) {
        const double t = degrees * GLM_PI / 180, n[2] = {cos(t), sin(t)}, d = WIDE / 2.0 * (n[0] + n[1]);
        for (int i = 0; i < WIDE * WIDE; i++) {
            const int x = i % WIDE, y = i / WIDE;
            mask[i] = x >= BORDER && x < WIDE - BORDER && y >= BORDER && y < WIDE - BORDER;
            truth[i] = covered(n, d, x, y);
        }
        const double exact = (WIDE - 2 * BORDER - 1) / fmax(fabs(n[0]), fabs(n[1])),
                     length = edge_length((MetricsSize){WIDE, WIDE}, traced, mask, truth);
        if (fabs(length / exact - 1) > 0.005)
            fail_msg("at %d degrees %.3f pixels, not %.3f", degrees, length, exact);
    }
}

// A method whose edge lies two pixels off: 2 x 20 wrong pixels along a length of 19.
static void test_edge_error(void **unused) {
    (void)unused;
    const MetricsSize size = {SIDE, SIDE};
    Picture picture = make_picture(1, 0, 2);
    assert_true(metrics_boundary(size, picture.traced, picture.truth, picture.distance));
    Metrics metrics =
        metrics_compare(size, picture.mask, picture.measured, picture.truth, picture.distance, 3);
    double length = edge_length(size, picture.traced, picture.mask, picture.truth);
    assert_true(fabs(edge_error(&metrics, length) - 40.0 / 19) < 1e-9);
    assert_true(metrics.interior.mae == 0 && edge_error(&metrics, 0) == 0);
}

// A wall seen straight on, its light square to it: the map's side of 2 * 3 units covers 6 / unit pixels.
static void test_map_side(void **unused) {
    (void)unused;
    LabArtist artist;
    TruthView truth_view;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(-0.6f, 0, 3), vec3_make(0.5f, 0.5f, 0.1f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 8), vec3_make(0, 0, 0), 0, 3, 1, 10);
    const TruthQuery query = {.kind = TRUTH_LIGHT};
    if (!lab_artist_open(&artist, "03") ||
        !truth_view_create(&truth_view, &scene, (MetricsSize){200, 160}, &query, &artist))
        fail_msg("%s", check_message());
    double side = edge_map_side(&truth_view), expected = 6 / closed_unit(&scene, 160);
    print_message("side of the map: %.2f pixels, expected %.2f\n", side, expected);
    assert_true(fabs(side / expected - 1) < 0.005);
    truth_view_destroy(&truth_view);
    lab_artist_close(&artist);
}

// The truth's own noise is less than a tenth of what counts at 640 x 480, in each scene. Here an eighth is
// allowed: the pixels are larger, and so is what differs within one. What lies between a trace of half the
// rays and the whole is charted as a frame is.
static void test_truth_noise(void **unused) {
    (void)unused;
    const MetricsSize size = {96, 72};
    LabArtist artist;
    assert_true(lab_artist_open(&artist, "03"));
    for (int s = 0; study_scene(s); s++) {
        const StudyScene *scene = study_scene(s);
        const Setting setting = {.edge_width = scene->edges ? 0 : METHOD_NO_EDGE, .object = TRUTH_NONE};
        StudyView view;
        Measured frame;
        MeasuredErrors errors;
        if (!view_create(&view, scene, 0, size, "/nowhere", &artist) || !measured_create(&frame, size))
            fail_msg("%s: %s", scene->name, check_message());
        for (int i = 0; i < size.width * size.height; i++)
            frame.visibility[i] = view.truth_view.visibility[i] + view.truth_view.noise[i];
        assert_true(view_compare(&view, scene, &setting, &frame, &errors));
        double inside = errors.interior_false_shadow + errors.interior_false_light;
        print_message("%s: inside %.6f of %.6f, edge %.4f pixels\n", scene->name, inside, scene->tolerance,
                      errors.off);
        assert_true(inside < scene->tolerance / 8 && errors.off < 0.5 / 8);
        measured_destroy(&frame);
        view_destroy(&view);
    }
    lab_artist_close(&artist);
}

// Where a method culls front faces, all is closed: a sheet would be missing in its map, which then looks
// cheap.
static void test_closed_receivers(void **unused) {
    (void)unused;
    static MethodList list;
    int scenes = 0;
    for (int s = 0; study_scene(s); s++) {
        Scene scene;
        bool culls = false;
        study_add_methods(&list, study_scene(s));
        for (int i = 0; i < list.count; i++)
            culls = culls || strcmp(list.methods[i].family, "front faces culled") == 0;
        study_scene(s)->make(&scene);
        scenes += culls;
        for (int i = 0; culls && i < scene.object_count; i++)
            assert_int_not_equal(scene.objects[i].shape, SHAPE_PLANE);
    }
    assert_true(scenes > 0);
}

static void make_path(char path[FILES_PATH], char folder[FILES_PATH], const char *name) {
    if (!folder[0])
        assert_true(files_make_temporary(folder));
    files_join(path, folder, name);
}

// What was measured is there again; a line that was cut off is not, and what follows it is.
static void test_state(void **unused) {
    (void)unused;
    char folder[FILES_PATH] = "", path[FILES_PATH];
    Measurements state;
    MeasuredTime times[8];
    const MeasuredErrors errors = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, -1, 2e9, 3};
    make_path(path, folder, "state");
    assert_true(measurements_open(&state, path) && measurements_errors(&state, 7) == NULL);
    assert_true(measurements_add_time(&state, &(MeasuredTime){7, 1.5, 2.5}) &&
                measurements_add_errors(&state, 7, &errors));
    fputs("time 0000000000000007 3.5 4.", state.file); // as kill -9 leaves it
    measurements_close(&state);
    assert_true(measurements_open(&state, path));
    assert_int_equal(measurements_times(&state, 7, times, 8), 1);
    assert_true(measurements_add_time(&state, &(MeasuredTime){7, 5.5, 6.5}) &&
                measurements_add_time(&state, &(MeasuredTime){8, 1, 1}));
    measurements_close(&state);
    assert_true(measurements_open(&state, path));
    assert_int_equal(measurements_times(&state, 7, times, 8), 2);
    assert_true(times[0].prepare == 1.5 && times[1].shade == 6.5 &&
                measurements_times(&state, 7, times, 1) == 1);
    assert_memory_equal(measurements_errors(&state, 7), &errors, sizeof errors);
    measurements_close(&state);
    files_remove(folder);
}

// A table of settings of one scene; the times' bars are 1 wide, and the second is on the front where `front`.
static void write_table(const char *path, double first_ms, double second_ms, bool front) {
    FILE *file = fopen(path, "w");
    findings_csv_head(file);
    for (int i = 0; i < 2; i++)
        fprintf(file,
                "edges,05,ours,\"linear\",\"a, map "
                "%d\",30,%g,1,0,0,0,0,0.01,0,0,0,0,0,0,0,0,0,0,0,0,0,0,6,1,1,0,0,0,0,%d,1,0,,\n",
                i, i ? second_ms : first_ms, i ? front : 1);
    fclose(file);
}

// Two settings of one error: the second is beaten only where it is surely slower. Whether it is on the front
// may change where the bars nearly touch in one table and overlap in the other, not where they are apart in
// both.
static void test_compare(void **unused) {
    (void)unused;
    char folder[FILES_PATH] = "", a[FILES_PATH], b[FILES_PATH], bad[FILES_PATH];
    FILE *nowhere = fopen("/dev/null", "w");
    int unexplained;
    make_path(a, folder, "a.csv");
    make_path(b, folder, "b.csv");
    make_path(bad, folder, "bad.csv");
    write_table(a, 10, 11.9, true);
    write_table(b, 10, 12.1, false);
    assert_true(findings_csv_compare(a, b, nowhere, &unexplained) && unexplained == 0);
    write_table(a, 14, 10, true);
    assert_true(findings_csv_compare(a, b, nowhere, &unexplained) && unexplained == 1);
    assert_true(findings_csv_compare(b, a, nowhere, &unexplained) && unexplained == 1);
    assert_true(files_write(bad, "scene,lab,whose\nedges,05\n"));
    assert_false(findings_csv_compare(a, bad, nowhere, &unexplained));
    assert_non_null(strstr(check_message(), "bad.csv:"));
    fclose(nowhere);
    files_remove(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_median),      cmocka_unit_test(test_front),
        cmocka_unit_test(test_edge_length), cmocka_unit_test(test_edge_angles),
        cmocka_unit_test(test_edge_error),  cmocka_unit_test(test_map_side),
        cmocka_unit_test(test_state),       cmocka_unit_test(test_truth_noise),
        cmocka_unit_test(test_compare),     cmocka_unit_test(test_closed_receivers)};
    return cmocka_run_group_tests_name("study", tests, NULL, NULL);
}
