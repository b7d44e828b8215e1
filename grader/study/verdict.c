// Chooses the cheapest setting that is enough in all views, tries other limits and single views, and says it
// in words.
#include "study/verdict.h"

#include "scene/check.h"
#include "scene/count.h"

#include <math.h>
#include <string.h>

#define SAME_COST                                                                                            \
    1.15 // times that differ by less are the same, whatever their bars say: another day may swap them
#define LIMIT_VARIED 0.2

static bool is_enough(const SceneFindings *findings, const MeasuredErrors *errors, double scale) {
    return finding_interior_error(errors) <= scale * findings->scene->tolerance &&
           errors->off <= scale * FINDING_MOST_OFF;
}

static bool is_enough_in(const SceneFindings *findings, const Finding *finding, double scale, int view) {
    bool enough = finding->drawn;
    for (int v = 0; v < STUDY_VIEWS; v++)
        if (view < 0 || v == view)
            enough = enough && is_enough(findings, &finding->views[v], scale);
    return enough;
}

// Ray tracing and the frame without shadows stand beside the methods.
static bool stands_aside(const Method *method) {
    return method->rays > 0 || strcmp(method->family, METHOD_BARE) == 0;
}

static bool may_be_chosen(const Finding *finding) {
    return finding->drawn && !finding->method.submission && !stands_aside(&finding->method);
}

static bool costs_as_little(const Point *point, const Point *cheapest) {
    return point->ms <= SAME_COST * cheapest->ms || !pareto_surely_faster(cheapest, point);
}

// Of two settings that take the same time, the one whose maps and atlases are smaller, then the one that
// costs less, then the one that errs less.
static bool is_less(const SceneFindings *findings, int a, int b) {
    const Cost *x = &findings->findings[a].cost, *y = &findings->findings[b].cost;
    const double pairs[][2] = {
        {x->held, y->held}, {x->counted, y->counted}, {findings->points[a].error, findings->points[b].error}};
    for (size_t i = 0; i < COUNT(pairs); i++)
        if (pairs[i][0] != pairs[i][1])
            return pairs[i][0] < pairs[i][1];
    return false;
}

int findings_choose(const SceneFindings *findings, double scale, int view) {
    int cheapest = -1, best = -1;
    for (int i = 0; i < findings->count; i++)
        if (may_be_chosen(&findings->findings[i]) &&
            is_enough_in(findings, &findings->findings[i], scale, view) &&
            (cheapest < 0 || findings->points[i].ms < findings->points[cheapest].ms))
            cheapest = i;
    for (int i = 0; i < findings->count && cheapest >= 0; i++)
        if (may_be_chosen(&findings->findings[i]) &&
            is_enough_in(findings, &findings->findings[i], scale, view) &&
            costs_as_little(&findings->points[i], &findings->points[cheapest]) &&
            (best < 0 || is_less(findings, i, best)))
            best = i;
    return best;
}

void findings_judge(SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        Point *point = &findings->points[i];
        point->error = finding_error(&finding->errors);
        point->ms = finding->drawn ? point->ms : -1;
        point->aside = stands_aside(&finding->method);
        finding->enough_views = 0;
        for (int v = 0; v < STUDY_VIEWS; v++)
            finding->enough_views += is_enough_in(findings, finding, 1, v);
        finding->enough = finding->enough_views == STUDY_VIEWS;
        finding->chosen = false;
    }
    int chosen = findings_choose(findings, 1, -1);
    if (chosen >= 0)
        findings->findings[chosen].chosen = true;
    pareto_mark(findings->points, (size_t)findings->count);
}

const Finding *findings_chosen(const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].chosen)
            return &findings->findings[i];
    return NULL;
}

const Finding *findings_next_cheaper(const SceneFindings *findings) {
    const Finding *chosen = findings_chosen(findings);
    const Point *limit = chosen ? &findings->points[chosen - findings->findings] : NULL, *best = NULL;
    for (int i = 0; limit && i < findings->count; i++) {
        const Point *point = &findings->points[i];
        const Finding *finding = &findings->findings[i];
        if (point->on_front && may_be_chosen(finding) && !finding->enough && point->ms < limit->ms &&
            (!best || point->ms > best->ms))
            best = point;
    }
    return best ? &findings->findings[best - findings->points] : NULL;
}

typedef struct Line {
    char *text;
    size_t size;
} Line;

static void tell_name(Line line, const char *before, const Finding *finding) {
    check_append(line.text, line.size, "%s%s, %s (lab %s)", before, finding->method.family,
                 finding->method.name, finding->method.lab);
}

// How far it is from the limits in its worst view.
static void tell_margin(Line line, const SceneFindings *findings, const Finding *chosen) {
    if (findings->scene->edges)
        check_append(line.text, line.size,
                     "; in the worst of %d views its edge is off by %.2f of %.2g pixels", STUDY_VIEWS,
                     chosen->worst_off, FINDING_MOST_OFF);
    else
        check_append(line.text, line.size, "; in the worst of %d views it errs by %.2f of %.2f %%",
                     STUDY_VIEWS, 100 * chosen->worst_inside, 100 * findings->scene->tolerance);
}

static void tell_equals(Line line, const SceneFindings *findings, const Finding *chosen) {
    const Point *point = &findings->points[chosen - findings->findings];
    const char *before = "; it costs no more than ";
    int told = 0;
    for (int i = 0; i < findings->count && told < 3; i++) {
        const Finding *other = &findings->findings[i];
        if (other == chosen || !other->enough || !may_be_chosen(other) ||
            !(costs_as_little(point, &findings->points[i]) && costs_as_little(&findings->points[i], point)))
            continue;
        tell_name(line, before, other);
        before = ", ";
        told++;
    }
}

static void tell_wrong(Line line, const SceneFindings *findings, const Finding *next) {
    tell_name(line, "; the next cheaper, ", next);
    check_append(line.text, line.size, ", is enough in %d views: ", next->enough_views);
    if (next->worst_inside <= findings->scene->tolerance)
        check_append(line.text, line.size, "its edge is off by %.2g pixels", next->worst_off);
    else
        check_append(line.text, line.size, "%.2g %% error inside, mostly false %s", 100 * next->worst_inside,
                     next->errors.interior_false_shadow > next->errors.interior_false_light ? "shadow"
                                                                                            : "light");
}

// What limits a fifth narrower or wider would ask for.
static void tell_limits(Line line, const SceneFindings *findings, const Finding *chosen) {
    bool hangs = false;
    for (int side = -1; side <= 1; side += 2) {
        int other = findings_choose(findings, 1 + side * LIMIT_VARIED, -1);
        if (other >= 0 && &findings->findings[other] == chosen)
            continue;
        check_append(line.text, line.size, "%s %d %% %s ask for ",
                     hangs ? ", and" : "; it hangs on the limits:", (int)lrint(100 * LIMIT_VARIED),
                     side < 0 ? "narrower ones" : "wider ones");
        if (other >= 0)
            tell_name(line, "", &findings->findings[other]);
        else
            check_append(line.text, line.size, "more than any setting gives");
        hangs = true;
    }
    if (!hangs)
        check_append(line.text, line.size, "; limits %d %% narrower or wider ask for the same",
                     (int)lrint(100 * LIMIT_VARIED));
}

// How many different settings single views would name.
static void tell_views(Line line, const SceneFindings *findings) {
    int named[STUDY_VIEWS], different = 0;
    for (int v = 0; v < STUDY_VIEWS; v++) {
        named[v] = findings_choose(findings, 1, v);
        bool is_new = true;
        for (int earlier = 0; earlier < v; earlier++)
            is_new = is_new && named[earlier] != named[v];
        different += is_new;
    }
    if (different > 1)
        check_append(line.text, line.size, "; one view alone would name %d different settings", different);
}

// The limits are for pictures of one size; the camera's angle is that of the picture's height.
static void tell_size(Line line, const SceneFindings *findings) {
    const MetricsSize size = findings->size;
    const char *but = "which do not show what is in those", *then = "";
    if (size.height < STUDY_HEIGHT)
        but = "whose pixels are larger: those", then = " may need more";
    else if (size.height > STUDY_HEIGHT)
        but = "whose pixels are smaller: those", then = " may do with less";
    else if (size.width == STUDY_WIDTH)
        return;
    check_append(line.text, line.size, "; these are pictures of %d x %d, %s of %d x %d%s", size.width,
                 size.height, but, STUDY_WIDTH, STUDY_HEIGHT, then);
}

void findings_tell(const SceneFindings *findings, char *text, size_t size) {
    const Finding *chosen = findings_chosen(findings), *next = findings_next_cheaper(findings);
    const Line line = {text, size};
    text[0] = '\0';
    if (!chosen) {
        check_append(text, size, "none of these settings is enough in all %d views", STUDY_VIEWS);
    } else {
        tell_name(line, "", chosen);
        tell_margin(line, findings, chosen);
        tell_equals(line, findings, chosen);
        if (next)
            tell_wrong(line, findings, next);
        else
            check_append(text, size, "; nothing that is cheaper is worth its error");
        tell_limits(line, findings, chosen);
    }
    tell_views(line, findings);
    tell_size(line, findings);
}
