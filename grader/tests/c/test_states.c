// Whatever state of OpenGL a lab leaves changed: its own frame is read right, and the next one is drawn
// right.
#include "compile/compiler.h"
#include "exam/worker_client.h"
#include "base/places.h"
#include "scene/check.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static WorkerClient client;
static Request request;

static void copy(const char *name) {
    char from[FILES_PATH], to[FILES_PATH], part[FILES_PATH];
    snprintf(part, sizeof part, "grader/tests/states/%s", name);
    places_path(from, part);
    files_join(to, client.folder, name);
    char *text = files_read(from, 1 << 20);
    assert_non_null(text);
    assert_true(files_write(to, text));
    free(text);
}

static void draw(int state, const char *view, int fresh, Image *image) {
    static Reply reply;
    request.knobs[0].value = (float)state;
    request.fresh = fresh;
    snprintf(request.view, sizeof request.view, "%s", view);
    assert_int_equal(worker_client_draw(&client, &request, image, &reply), DRAW_OK);
    if (reply.message[0])
        fail_msg("state %d, %s: %s", state, view, reply.message);
}

// The frame that leaves the state changed, the next of the same resources, and one of new ones.
static void check_state(int state, const char *view, const Image *right) {
    static const struct {
        bool left;
        int fresh;
    } frames[] = {{true, 1}, {true, 0}, {false, 0}, {true, 0}, {false, 1}};
    Image image = {0};
    for (unsigned i = 0; i < COUNT(frames); i++) {
        draw(frames[i].left ? state : -1, view, frames[i].fresh, &image);
        if (memcmp(image.rgba, right->rgba, image_bytes(&image)) != 0)
            fail_msg("state %d, %s: frame %u has another picture", state, view, i);
    }
    image_destroy(&image);
}

static int count_states(void) {
    static Description description;
    static Reply reply;
    assert_int_equal(worker_client_describe(&client, &request, &description, &reply), DRAW_OK);
    return (int)description.knobs[0].high + 1;
}

static bool is_plain(const Image *image) {
    return memcmp(image->rgba, image->rgba + 4, image_bytes(image) - 4) == 0;
}

static void check_context(ContextKind kind) {
    static const char *const views[] = {VIEW_PICTURE, VIEW_VISIBILITY, "target"};
    Random random = {3};
    client.context = kind;
    request = (Request){
        .magic = PROTOCOL_MAGIC, .width = 52, .height = 36, .knobs = {{"state", -1}}, .knob_count = 1};
    assert_true(scene_make(&request.scene, "table spot", &random));
    const int count = count_states();
    assert_true(count >= 60);
    for (unsigned v = 0; v < COUNT(views); v++) {
        Image right = {0};
        draw(-1, views[v], 1, &right);
        assert_false(is_plain(&right));
        for (int state = 0; state < count; state++)
            check_state(state, views[v], &right);
        image_destroy(&right);
        worker_client_stop(&client); // what the lab compares with belongs to one view
    }
    print_message("%d states, %s\n", count, context_name(kind));
}

static void test_osmesa(void **unused) {
    (void)unused;
    check_context(CONTEXT_OSMESA);
}

static void test_egl(void **unused) {
    (void)unused;
    check_context(CONTEXT_EGL);
}

static int build(void **unused) {
    (void)unused;
    static char log[COMPILE_LOG];
    client = (WorkerClient){.trust = TRUST_OURS};
    assert_true(files_make_temporary(client.folder));
    copy("lab.c");
    copy("states.h");
    if (!compiler_build(client.folder, NULL, log))
        fail_msg("%s", log);
    return 0;
}

static int leave(void **unused) {
    (void)unused;
    worker_client_stop(&client);
    files_remove(client.folder);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_osmesa), cmocka_unit_test(test_egl)};
    return cmocka_run_group_tests_name("states", tests, build, leave);
}
