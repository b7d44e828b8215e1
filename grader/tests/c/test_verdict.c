// What a scene needs: the cheapest that is enough in all views, and the words for how sure that is.
#include "study/chart_layout.h"
#include "study/verdict.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static Finding *add_finding(SceneFindings *findings, double ms, double inside, double off, bool submission) {
    Finding *finding = &findings->findings[findings->count];
    *finding =
        (Finding){.method = {.lab = "05", .family = "linear", .submission = submission}, .drawn = true};
    for (int v = 0; v < STUDY_VIEWS; v++)
        finding->views[v] =
            (MeasuredErrors){.interior_false_light = inside, .edge_false_light = 0.001, .off = off};
    finding_errors(finding);
    snprintf(finding->method.name, sizeof finding->method.name, "map %d", findings->count);
    findings->points[findings->count++] = (Point){.ms = ms, .mad = 0.01};
    return finding;
}

static void expect_told(const SceneFindings *findings, const char *part, bool told) {
    char text[VERDICT_TEXT];
    findings_tell(findings, text, sizeof text);
    if ((strstr(text, part) != NULL) != told)
        fail_msg("\"%s\" %s in \"%s\"", part, told ? "is missing" : "stands", text);
}

// The cheapest without interior error and with at most half a pixel at the edge, of ours; what lies before it
// errs. Rays and submissions are never chosen.
static void test_need(void **unused) {
    (void)unused;
    static SceneFindings findings;
    static const StudyScene scene = {.name = "made up", .tolerance = 1e-4, .edges = true};
    findings = (SceneFindings){.scene = &scene, .size = {STUDY_WIDTH, STUDY_HEIGHT}};
    add_finding(&findings, 1, 0.5, 0.1, false);                  // leaks
    add_finding(&findings, 2, 0.00001, 0.7, false);              // its edge is off; next cheaper
    add_finding(&findings, 3, 0, 0.3, false);                    // needed
    add_finding(&findings, 2.5, 0, 0.3, true);                   // not ours
    add_finding(&findings, 1.5, 0, 0.3, false)->method.rays = 4; // not of a lab
    add_finding(&findings, 4, 0, 0.1, false);                    // more than needed
    findings_judge(&findings);
    assert_ptr_equal(findings_chosen(&findings), &findings.findings[2]);
    assert_true(!findings.points[4].on_front && findings.findings[2].enough_views == STUDY_VIEWS);
    findings.points[1].on_front = true;
    assert_ptr_equal(findings_next_cheaper(&findings), &findings.findings[1]);
    expect_told(&findings,
                "linear, map 2 (lab 05); in the worst of 6 views its edge is off by 0.30 of 0.5 pixels",
                true);
    expect_told(
        &findings,
        "the next cheaper, linear, map 1 (lab 05), is enough in 0 views: its edge is off by 0.7 pixels",
        true);
    expect_told(&findings, "narrower or wider ask for the same", true);
    expect_told(&findings, "one view alone", false);
    expect_told(&findings, "may need more", false);
    findings.size.width /= 2; // the camera's angle is that of the height: the pixels stay
    expect_told(&findings, "320 x 480, which do not show what is in those of 640 x 480", true);
    findings.size.height /= 2;
    expect_told(&findings, "320 x 240, whose pixels are larger: those of 640 x 480 may need more", true);
    findings.size.height *= 4;
    expect_told(&findings, "320 x 960, whose pixels are smaller: those of 640 x 480 may do with less", true);
    findings.count = 2;
    findings_judge(&findings);
    expect_told(&findings, "none of these settings is enough in all 6 views", true);
}

// One view in which it is not enough excludes a setting, and the verdict says that others saw it otherwise; a
// limit that a fifth would move it over is said to be one that it hangs on; of equal times the smaller error
// is taken.
static void test_sure_need(void **unused) {
    (void)unused;
    static SceneFindings findings;
    static const StudyScene scene = {.name = "made up", .tolerance = 1e-4, .edges = true};
    findings = (SceneFindings){.scene = &scene, .size = {STUDY_WIDTH, STUDY_HEIGHT}};
    Finding *first = add_finding(&findings, 1, 0, 0.3, false);
    first->views[4].off = 0.9;
    finding_errors(first);
    add_finding(&findings, 2, 0, 0.45, false);
    Finding *equal = add_finding(&findings, 2.2, 0, 0.44, false);
    equal->views[0].edge_false_light = 0; // errs less
    finding_errors(equal);
    add_finding(&findings, 3, 0, 0.3, false);
    findings_judge(&findings);
    assert_ptr_equal(findings_chosen(&findings), equal);
    assert_int_equal(first->enough_views, STUDY_VIEWS - 1);
    expect_told(&findings, "it costs no more than linear, map 1", true);
    expect_told(&findings, "it hangs on the limits: 20 % narrower ones ask for linear, map 3", true);
    expect_told(&findings, "one view alone would name 2 different settings", true);
    assert_int_equal(findings_choose(&findings, 1, 4), 2);
    assert_int_equal(findings_choose(&findings, 1, 0), 0);
    assert_int_equal(findings_choose(&findings, 0.1, -1), -1);
    assert_int_equal(findings_choose(&findings, 2, -1), 0);
}

// Short names: equal numbers of a pair count once, others stay, and a name without any gives its first word.
static void test_labels(void **unused) {
    (void)unused;
    static const char *const names[][2] = {{"512 x 512", "512"},
                                           {"32 samples, radius x 0.5, 256 x 256", "32/0.5/256"},
                                           {"2 x 4 lamps", "2/4"},
                                           {"geometry shader", "geometry"}};
    char text[LABEL_TEXT];
    for (int i = 0; i < 4; i++) {
        label_write(names[i][0], text);
        assert_string_equal(text, names[i][1]);
    }
}

// A curve runs along the number with the most values, one step at a time, and not from one method to another.
static void test_curves(void **unused) {
    (void)unused;
    static SceneFindings findings;
    static const char *const names[] = {"bias 1, 256 x 256", "bias 2, 256 x 256", "bias 1, 512 x 512",
                                        "bias 1, 1024 x 1024"};
    findings = (SceneFindings){.count = 0};
    for (int i = 0; i < 4; i++)
        snprintf(add_finding(&findings, 1, 0, 0, false)->method.name, METHOD_NAME, "%s", names[i]);
    assert_int_equal(label_before(&findings, 0), -1);
    assert_int_equal(label_before(&findings, 1), -1);
    assert_int_equal(label_before(&findings, 2), 0);
    assert_int_equal(label_before(&findings, 3), 2);
    findings.findings[2].method.family = "another";
    assert_int_equal(label_before(&findings, 3), 0);
}

static bool apart(LayoutBox a, LayoutBox b) {
    return a.left >= b.right || b.left >= a.right || a.top >= b.bottom || b.top >= a.bottom;
}

// Twenty settings at one place, at the right end of a line, and two lines at one height: no mark hides
// another one, and no name or label a mark, a name or another label.
static void test_layout(void **unused) {
    (void)unused;
    static SceneFindings findings;
    static LayoutPoint points[METHOD_MOST];
    enum { MANY = 20 };
    const LayoutAxis time = {0.1, 10, 0, 540}, error = {1e-4, 1, 300, 0};
    const LayoutBox plot = {0, 0, 300, 300};
    LayoutName names[2] = {{.text = "one sample", .y = 150}, {.text = "no shadow", .y = 150}};
    findings = (SceneFindings){.count = 0};
    for (int i = 0; i < MANY; i++) {
        add_finding(&findings, 1, 0, 0, false);
        findings.points[i].error = 0.01;
        points[i].drawn = true;
    }
    layout_marks(&findings, &time, &error, plot, points);
    layout_names(points, findings.count, plot, 12, names, 2);
    layout_labels(&findings, plot, 12, names, 2, points);
    int labelled = 0;
    assert_true(apart(names[0].box, names[1].box));
    for (int i = 0; i < MANY; i++) {
        const LayoutBox mark = {points[i].mark_x - LAYOUT_MARK, points[i].mark_y - LAYOUT_MARK,
                                points[i].mark_x + LAYOUT_MARK, points[i].mark_y + LAYOUT_MARK};
        assert_true(points[i].x == 270 && points[i].y == 150);
        labelled += points[i].labelled;
        for (int n = 0; n < 2; n++)
            assert_true(apart(names[n].box, mark) &&
                        (!points[i].labelled || apart(names[n].box, points[i].text)));
        for (int j = 0; j < MANY; j++) {
            bool marks_apart = fabs(points[i].mark_x - points[j].mark_x) >= 2 * LAYOUT_MARK ||
                               fabs(points[i].mark_y - points[j].mark_y) >= 2 * LAYOUT_MARK;
            assert_true(i == j || marks_apart);
            assert_true(i == j || !points[i].labelled || !points[j].labelled ||
                        apart(points[i].text, points[j].text));
        }
    }
    assert_true(labelled > 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_need), cmocka_unit_test(test_sure_need),
                                       cmocka_unit_test(test_labels), cmocka_unit_test(test_curves),
                                       cmocka_unit_test(test_layout)};
    return cmocka_run_group_tests_name("verdict", tests, NULL, NULL);
}
