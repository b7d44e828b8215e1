// bench_truth: milliseconds of the ray-traced truth, in packets and one ray at a time, in turn. Not a test.
#include "check.h"
#include "process.h"
#include "truth/truth.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 640, HEIGHT = 480, MAX_RUNS = 15, SPHERES = 10 };

typedef struct Case {
    const char *name;
    TruthQuery query;
    int runs, rays;
} Case;

static void add(Scene *scene, Shape shape, vec3s center, vec3s half_size) {
    scene->objects[scene->object_count++] = (Object){
        .shape = (int32_t)shape, .world_from_object = glms_scale(glms_translate_make(center), half_size)};
}

// Two rows of spheres on a floor that fills the picture, with a spot light above: 9,638 triangles.
static Scene make_scene(void) {
    Scene scene = {.camera = {.eye = vec3_make(0, 5, 9),
                              .target = vec3_make(0, 0.5f, 0),
                              .fov_y = glm_rad(45),
                              .near_plane = 0.5f,
                              .far_plane = 60}};
    add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(20, 1, 20));
    for (int i = 0; i < SPHERES; i++)
        add(&scene, SHAPE_SPHERE, vec3_make(1.6f * (float)(i % 5) - 3.2f, 0.8f, i < 5 ? -1.2f : 1.2f),
            vec3_make(0.7f, 0.7f, 0.7f));
    for (int i = 0; i < 3; i++)
        add(&scene, SHAPE_BOX, vec3_make(3.0f * (float)i - 3, 0.3f, 3), vec3_make(0.3f, 0.3f, 0.3f));
    scene.lights[scene.light_count++] =
        (Light){.kind = LIGHT_SPOT, .position = vec3_make(3, 7, 3), .target = vec3_make(0, 0, 0)};
    return scene;
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int count) {
    qsort(values, (size_t)count, sizeof *values, by_value);
    return values[count / 2];
}

static double mean_lit(const TruthPicture *picture, const float *visibility) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < (size_t)picture->width * (size_t)picture->height; i++)
        if (picture->hits[i].object != TRUTH_NONE) {
            sum += visibility[i];
            count++;
        }
    return sum / (double)(count ? count : 1);
}

static bool time_case(const Truth *truth, const TruthPicture *picture, const Case *timed, float *visibility) {
    double milliseconds[2][MAX_RUNS], mean[2] = {0};
    for (int run = 0; run < timed->runs; run++)
        for (int single = 0; single < 2; single++) {
            TruthQuery query = timed->query;
            query.one_by_one = single == 1;
            double start = process_now();
            if (!truth_trace(truth, picture, &query, visibility))
                return false;
            milliseconds[single][run] = 1000 * (process_now() - start);
            mean[single] = mean_lit(picture, visibility);
        }
    double packets = median(milliseconds[0], timed->runs), singles = median(milliseconds[1], timed->runs);
    printf("%-26s %10.1f %10.1f %7.1f %9.1f %9.1f  %.6f %.6f\n", timed->name, packets, singles,
           singles / packets, timed->rays / packets * WIDTH * HEIGHT / 1e3,
           timed->rays / singles * WIDTH * HEIGHT / 1e3, mean[0], mean[1]);
    return true;
}

static void time_look(const Truth *truth, TruthPicture *picture) {
    double milliseconds[MAX_RUNS];
    for (int run = 0; run < MAX_RUNS; run++) {
        double start = process_now();
        truth_look(truth, picture);
        milliseconds[run] = 1000 * (process_now() - start);
    }
    double middle = median(milliseconds, MAX_RUNS);
    printf("%-26s %10.1f %28.1f\n", "primary hits", middle, WIDTH * HEIGHT / middle / 1e3);
}

static bool bench(void) {
    static const TruthArea light = {{{3, 7, 3}}, {{0.5f, 0, 0}}, {{0, 0, 0.5f}}};
    static const Case cases[] = {
        {"hard shadow", {.kind = TRUTH_LIGHT}, MAX_RUNS, 1},
        {"area light, 256 samples", {.kind = TRUTH_DISC, .area = light, .samples = 256, .seed = 1}, 3, 256},
        {"ambient occlusion, 512", {.kind = TRUTH_OCCLUSION, .samples = 512, .seed = 1}, 3, 512},
    };
    Scene scene = make_scene();
    Truth truth = {0};
    TruthPicture picture = {0};
    float *visibility = calloc((size_t)WIDTH * HEIGHT, sizeof *visibility);
    bool ok = visibility && truth_create(&truth, &scene) && truth_picture_create(&picture, WIDTH, HEIGHT);
    if (ok) {
        printf("%d x %d, %d threads; medians of %d and 3 runs\n%-26s %10s %10s %7s %9s %9s  %s\n", WIDTH,
               HEIGHT, TRUTH_THREADS, MAX_RUNS, "", "packets ms", "singly ms", "ratio", "Mray/s", "singly",
               "mean lit");
        time_look(&truth, &picture);
    }
    for (size_t i = 0; ok && i < sizeof cases / sizeof cases[0]; i++)
        ok = time_case(&truth, &picture, &cases[i], visibility);
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    free(visibility);
    return ok;
}

int main(void) {
    if (bench())
        return 0;
    fprintf(stderr, "bench_truth: %s\n", check_message());
    return 1;
}
