// Takes each object and light of an exam's scenes away, draws solution and solution without the task again,
// and counts what shows something else.
#include "proof/scene_needs.h"

#include "scene/check.h"
#include "scene/count.h"
#include "score/score.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *scene;
    int object;
    const char *why;
} excuses[] = {
    {"edge", 0,
     "the floor: the lens looks at the map around one of its points, and only the picture shows it"},
    {"planar table", 6,
     "the box under the table: the table hides it, and who flattens what lies under a receiver shows its "
     "shadow"},
    {"planar grazing", 1,
     "the sheet that the sun grazes from before: without the task it is lit, too, and a facing test with a "
     "tolerance leaves it dark"},
    {"short sight", 3,
     "the box before the near plane: the solution does not show it, and who has another near plane does"},
};

const char *scene_needs_excuse(const char *scene, int object) {
    for (size_t i = 0; i < COUNT(excuses); i++)
        if (strcmp(excuses[i].scene, scene) == 0 && excuses[i].object == object)
            return excuses[i].why;
    return NULL;
}

static int shape_triangles(Shape shape) {
    Mesh mesh;
    bool created = mesh_create(&mesh, shape);
    INVARIANT(created);
    int triangles = mesh.index_count / 3;
    mesh_destroy(&mesh);
    return triangles;
}

int scene_needs_triangles(const Scene *scene) {
    int triangles = 0;
    for (int i = 0; i < scene->object_count; i++)
        triangles += shape_triangles((Shape)scene->objects[i].shape);
    return triangles;
}

void scene_needs_describe(char text[ECONOMY_TEXT], const char *lab, const SceneNeeds *economy) {
    int shapes[SHAPE_COUNT] = {0};
    for (int i = 0; i < economy->first.object_count; i++)
        shapes[economy->first.objects[i].shape]++;
    snprintf(text, ECONOMY_TEXT, "| %s | %s | %d | %d | %d | %d | %d |", lab, economy->scene,
             shapes[SHAPE_PLANE], shapes[SHAPE_BOX], shapes[SHAPE_SPHERE], shapes[SHAPE_ARCH],
             scene_needs_triangles(&economy->first));
}

bool scene_needs_has(const Scene *scene, int thing) {
    if (thing < SCENE_MAX_OBJECTS)
        return thing < scene->object_count;
    return scene->light_count > 1 && thing - SCENE_MAX_OBJECTS < scene->light_count;
}

double scene_needs_least(const SceneNeeds *economy) {
    double least = 1;
    for (int thing = 0; thing < ECONOMY_THINGS; thing++)
        if (scene_needs_has(&economy->first, thing) && !scene_needs_excuse(economy->scene, thing))
            least = fmin(least, economy->need[thing]);
    return least;
}

void scene_needs_take_away(Scene *scene, int thing) {
    int light = thing - SCENE_MAX_OBJECTS;
    if (light < 0) {
        scene->object_count--;
        memmove(&scene->objects[thing], &scene->objects[thing + 1],
                (size_t)(scene->object_count - thing) * sizeof scene->objects[0]);
    } else {
        scene->light_count--;
        memmove(&scene->lights[light], &scene->lights[light + 1],
                (size_t)(scene->light_count - light) * sizeof scene->lights[0]);
    }
}

// Share of the pixels where just one of the variants shows the phenomenon, or both do and differ.
static double changed_share(const Variant *before, const Variant *after) {
    size_t changed = 0, bytes = image_bytes(&before->reference);
    for (size_t at = 0; at < bytes; at += 4) {
        bool shown = score_pixel(&before->reference, &before->without, at) > 0;
        bool still = score_pixel(&after->reference, &after->without, at) > 0;
        changed += shown != still || (shown && score_pixel(&before->reference, &after->reference, at) > 0);
    }
    return (double)changed / ((double)bytes / 4);
}

static bool draw(Painters *roster, Solved solved, const Request *request, Image *image) {
    static Reply reply;
    const Painter *painter = painters_get(roster, solved, NULL);
    return painter && painters_draw(roster, painter, request, image, &reply);
}

// What an object or a light is needed for in one variant: see SceneNeeds.
static bool find_need(const Variant *whole, Painters *roster, const char *task, int thing, double enough,
                      double *need) {
    static Variant lacking;
    lacking = (Variant){.request = whole->request};
    scene_needs_take_away(&lacking.request.scene, thing);
    bool ok = draw(roster, (Solved){SOLVED_ALL, NULL}, &lacking.request, &lacking.reference) &&
              draw(roster, (Solved){SOLVED_ALL_BUT, task}, &lacking.request, &lacking.without);
    *need = ok ? changed_share(whole, &lacking) : 0;
    if (ok && *need < enough) {
        ok = draw(roster, (Solved){SOLVED_NONE, NULL}, &lacking.request, &lacking.skeleton);
        *need = ok && !exam_acceptable(&lacking, 0) ? 1 : *need;
    }
    image_destroy(&lacking.reference);
    image_destroy(&lacking.without);
    image_destroy(&lacking.skeleton);
    return ok;
}

static bool look_at_check(SceneNeeds *economy, const Exam *exam, Painters *roster, int c, double enough) {
    const Check *check = &exam->rubric->checks[c];
    bool ok = true;
    for (int thing = 0; ok && thing < ECONOMY_THINGS; thing++) {
        double sum = 0, need = 0;
        int count = 0;
        if (!scene_needs_has(&economy->first, thing) || economy->need[thing] >= enough)
            continue;
        for (int n = 0; ok && n < check->variants; n++)
            if (strcmp(exam->variants[c][n].scene, economy->scene) == 0 &&
                scene_needs_has(&exam->variants[c][n].request.scene, thing)) {
                ok = find_need(&exam->variants[c][n], roster, check->task, thing, enough, &need);
                sum += need;
                count++;
            }
        economy->need[thing] = fmax(economy->need[thing], count > 0 ? sum / count : 0);
    }
    return ok;
}

bool scene_needs_look(SceneNeeds *economy, const Exam *exam, Painters *roster, double enough) {
    bool ok = true;
    for (int c = 0; ok && c < exam->rubric->check_count; c++)
        if (rubric_uses_scene(&exam->rubric->checks[c], economy->scene)) {
            for (int n = 0; economy->first.object_count == 0 && n < exam->rubric->checks[c].variants; n++)
                if (strcmp(exam->variants[c][n].scene, economy->scene) == 0)
                    economy->first = exam->variants[c][n].request.scene;
            ok = look_at_check(economy, exam, roster, c, enough);
        }
    return ok;
}

static int list_scenes(SceneNeeds *economies, const Rubric *rubric) {
    int count = 0;
    for (int i = 0; scene_name(i); i++) {
        int uses = 0;
        for (int c = 0; c < rubric->check_count; c++)
            uses += rubric_uses_scene(&rubric->checks[c], scene_name(i));
        INVARIANT(count < ECONOMY_MAX_SCENES);
        if (uses > 0)
            economies[count++] = (SceneNeeds){.scene = scene_name(i)};
    }
    return count;
}

static bool look_all(SceneNeeds *economies, int count, const Exam *exam, Painters *roster, double enough) {
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = scene_needs_look(&economies[i], exam, roster, enough);
    return ok;
}

int scene_needs_measure(SceneNeeds *economies, const Rubric *rubric, WorkerClient *worker, int seeds,
                        double enough) {
    Painters roster = {.rubric = rubric, .client = *worker};
    Exam *exam = calloc(1, sizeof *exam);
    int count = list_scenes(economies, rubric);
    bool ok = exam != NULL, all = false;
    for (int seed = 1; ok && !all && seed <= seeds; seed++) {
        ok = exam_create(exam, rubric, &roster, (uint64_t)seed) &&
             look_all(economies, count, exam, &roster, enough);
        all = true;
        for (int i = 0; i < count; i++)
            all = all && scene_needs_least(&economies[i]) >= enough;
        exam_destroy(exam);
    }
    free(exam);
    *worker = roster.client;
    roster.client = (WorkerClient){0}; // goes on
    painters_destroy(&roster);
    return ok ? count : -1;
}
