#include "grade/later_frame.h"

#include "score/score.h"

#include <string.h>

#define TURN 40.0f   // degrees: far enough that objects and sky change places
#define LEAST 0.001f // share of the pixels that may differ

static const Request *last_picture(const Exam *exam) {
    const Rubric *rubric = exam->rubric;
    for (int c = rubric->check_count - 1; c >= 0; c--)
        if (strcmp(rubric->checks[c].view, VIEW_PICTURE) == 0)
            return &exam->variants[c][0].request;
    return NULL;
}

static void turn(Camera *camera) {
    vec3s arm = glms_vec3_sub(camera->eye, camera->target);
    arm = glms_vec3_rotate(arm, glm_rad(TURN), vec3_make(0, 1, 0));
    camera->eye = glms_vec3_add(camera->target, arm);
}

bool later_frame_is_same(const Exam *exam, WorkerClient *student) {
    static Reply reply;
    static Request request;
    Image first = {0}, after = {0}, alone = {0};
    if (!last_picture(exam))
        return true;
    request = *last_picture(exam);
    bool drawn = worker_client_draw(student, &request, &first, &reply) == DRAW_OK;
    turn(&request.scene.camera);
    request.fresh = 0;
    drawn = drawn && worker_client_draw(student, &request, &after, &reply) == DRAW_OK;
    request.fresh = 1;
    drawn = drawn && worker_client_draw(student, &request, &alone, &reply) == DRAW_OK;
    bool same = !drawn || score_mask(&alone, &after) <= LEAST;
    image_destroy(&first);
    image_destroy(&after);
    image_destroy(&alone);
    return same;
}
