#include "tests/helpers/truth_points.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

double truth_point(const Scene *scene, vec3s position, vec3s normal, const TruthQuery *query, int tiles) {
    Truth truth = {0};
    TruthPicture picture = {0};
    int count = 16 * tiles;
    float *visibility = calloc((size_t)count, sizeof *visibility);
    assert_non_null(visibility);
    assert_true(truth_create(&truth, scene) && truth_picture_create(&picture, count / 4, 4));
    for (int i = 0; i < count; i++)
        picture.hits[i] = (TruthHit){.position = position, .face_normal = normal, .normal = normal};
    assert_true(truth_trace(&truth, &picture, query, visibility));
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += visibility[i];
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    free(visibility);
    return sum / count;
}

void truth_point_add(Scene *scene, Shape shape, mat4s world_from_object) {
    scene->objects[scene->object_count++] =
        (Object){.shape = (int32_t)shape, .world_from_object = world_from_object};
}

double truth_point_noise(double share, double samples) {
    return 4 * sqrt(share * (1 - share) / samples);
}
