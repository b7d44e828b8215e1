#include "grade/later_frame.h"

#include "grade/remarks.h"
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

// Of the second frame, which was drawn with that result after the first one.
static const char *judge(DrawResult drawn, const Image *after, Request *request, WorkerClient *student) {
    static Reply reply;
    Image alone = {0};
    if (drawn != DRAW_OK && drawn != DRAW_FAULT)
        return REMARK "the camera was turned, and no second frame came: turn it in the window";
    request->fresh = 1;
    bool differs = drawn == DRAW_OK && worker_client_draw(student, request, &alone, &reply) == DRAW_OK &&
                   score_mask(&alone, after) > LEAST;
    image_destroy(&alone);
    return differs ? REMARK
               "a frame hangs on the frame before it: turn the camera in the window, and look for "
               "what is not cleared, or is kept in a variable"
                   : NULL;
}

const char *later_frame_remark(const Exam *exam, WorkerClient *student) {
    static Reply reply;
    static Request request;
    Image picture = {0};
    const char *remark = NULL;
    if (!last_picture(exam))
        return NULL;
    request = *last_picture(exam);
    if (worker_client_draw(student, &request, &picture, &reply) == DRAW_OK) {
        turn(&request.scene.camera);
        request.fresh = 0;
        const DrawResult drawn = worker_client_draw(student, &request, &picture, &reply);
        remark = judge(drawn, &picture, &request, student);
    }
    image_destroy(&picture);
    return remark;
}
