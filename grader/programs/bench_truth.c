// bench_truth: milliseconds of the ray-traced truth, in turn: in packets, the packets' rays one at a time,
// and pixel by pixel (truth/truth_plain.h), which is how one would trace without a thought. Not a test.
// "wall" is what passes on the clock, "cpu" the processor time divided by the threads: the same on an idle
// machine.
#include "scene/check.h"
#include "base/command_line.h"
#include "scene/count.h"
#include "base/process.h"
#include "base/statistics.h"
#include "truth/truth_plain.h"
#include "truth/truth.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { WIDTH = 640, HEIGHT = 480, MAX_RUNS = 15, SPHERES = 10 };

typedef struct TimedQuery {
    const char *name;
    TruthQuery query;
    int runs, rays;
} TimedQuery;

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

static double cpu_milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
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

typedef enum RayOrder { RAYS_PACKETS, RAYS_SINGLY, RAYS_PIXELS, RAYS_COUNT } RayOrder;

static const char *const ray_orders[] = {"packets", "singly", "pixels"};

typedef struct Times {
    double wall[MAX_RUNS], cpu[MAX_RUNS], mean; // milliseconds, mean visibility
} Times;

static bool time_run(const Truth *truth, const TruthPicture *picture, TruthQuery query, RayOrder order,
                     float *visibility, Times *times, int run) {
    double start = process_now(), start_cpu = cpu_milliseconds();
    bool ok = true;
    query.one_by_one = order == RAYS_SINGLY;
    if (order == RAYS_PIXELS)
        truth_trace_plainly(truth, picture, &query, visibility);
    else
        ok = truth_trace(truth, picture, &query, visibility);
    times->wall[run] = 1000 * (process_now() - start);
    times->cpu[run] = (cpu_milliseconds() - start_cpu) / TRUTH_THREADS;
    times->mean = mean_lit(picture, visibility);
    return ok;
}

static void print_line(const char *name, const char *order, Times *times, int runs, int rays) {
    double wall = statistics_median(times->wall, (size_t)runs),
           cpu = statistics_median(times->cpu, (size_t)runs);
    printf("%-26s %-8s %9.1f %9.1f %9.1f", name, order, wall, cpu, rays / cpu * WIDTH * HEIGHT / 1e3);
    if (!isnan(times->mean))
        printf("   %.6f", times->mean);
    printf("\n");
}

static bool time_query(const Truth *truth, const TruthPicture *picture, const TimedQuery *timed,
                       float *visibility) {
    Times times[RAYS_COUNT];
    for (int run = 0; run < timed->runs; run++)
        for (int order = 0; order < RAYS_COUNT; order++)
            if (!time_run(truth, picture, timed->query, (RayOrder)order, visibility, &times[order], run))
                return false;
    for (int order = 0; order < RAYS_COUNT; order++)
        print_line(order == 0 ? timed->name : "", ray_orders[order], &times[order], timed->runs, timed->rays);
    return true;
}

static void time_look(const Truth *truth, TruthPicture *picture) {
    Times times = {.mean = NAN};
    for (int run = 0; run < MAX_RUNS; run++) {
        double start = process_now(), start_cpu = cpu_milliseconds();
        truth_look(truth, picture);
        times.wall[run] = 1000 * (process_now() - start);
        times.cpu[run] = (cpu_milliseconds() - start_cpu) / TRUTH_THREADS;
    }
    print_line("primary hits", "packets", &times, MAX_RUNS, 1);
}

static bool bench(void) {
    const TruthArea light = {{{3, 7, 3}}, {{0.5f, 0, 0}}, {{0, 0, 0.5f}}};
    const TimedQuery queries[] = {
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
        printf("%d x %d, %d threads; medians of %d and 3 runs, milliseconds\n", WIDTH, HEIGHT, TRUTH_THREADS,
               MAX_RUNS);
        printf("%-35s %9s %9s %9s   %s\n", "", "wall", "cpu", "Mray/s", "mean lit");
        time_look(&truth, &picture);
    }
    for (size_t i = 0; ok && i < COUNT(queries); i++)
        ok = time_query(&truth, &picture, &queries[i], visibility);
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    free(visibility);
    return ok;
}

static const CommandLine command_line = {
    .program = "bench_truth",
    .forms = "",
    .about = "Times the rays of the truth. For `make bench`; not a test.\n",
    .options = (const Option[]){{0}},
};

int main(int count, char **arguments) {
    command_line_take(&command_line, NULL, count, arguments);
    if (bench())
        return 0;
    fprintf(stderr, "bench_truth: %s\n", check_message());
    return 1;
}
