// The parts without GL: random numbers, meshes, scenes, shader files and processes.
#include "scene/check.h"
#include "compile/compiler.h"
#include "base/files.h"
#include "base/process.h"
#include "scene/count.h"
#include "scene/palette.h"
#include "scene/random.h"
#include "scene/scene.h"
#include "scene/shader_source.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

// The first numbers of splitmix64 for the seed 1234567, as published with the reference code.
static void test_random(void **unused) {
    (void)unused;
    Random random = {1234567};
    assert_true(random_next(&random) == 6457827717110365317u);
    assert_true(random_next(&random) == 3203168211198807973u);
    assert_true(random_next(&random) == 9817491932198370423u);
    double sum = 0;
    for (int i = 0; i < 10000; i++)
        sum += random_range(&random, -1, 1);
    assert_true(fabs(sum / 10000) < 4 * 0.57735 / 100); // four standard errors of the mean
}

static vec3s corner(const Mesh *mesh, int i) {
    return mesh->vertices[mesh->indices[i]].position;
}

// Volume by the divergence theorem: right only when every triangle is turned outwards and the mesh is closed.
static double volume(Shape shape) {
    Mesh mesh;
    double sum = 0;
    assert_true(mesh_create(&mesh, shape));
    for (int i = 0; i < mesh.index_count; i += 3)
        sum +=
            glms_vec3_dot(corner(&mesh, i), glms_vec3_cross(corner(&mesh, i + 1), corner(&mesh, i + 2))) / 6;
    mesh_destroy(&mesh);
    return sum;
}

static void test_meshes(void **unused) {
    (void)unused;
    assert_true(fabs(volume(SHAPE_BOX) - 8) < 1e-5);
    double sphere = 4 * GLM_PI / 3, measured = volume(SHAPE_SPHERE);
    assert_true(measured < sphere &&
                measured > 0.97 * sphere); // inscribed: 32 slices lose 0.6 %, 16 stacks 1.3 %
}

static void test_scenes(void **unused) {
    (void)unused;
    for (int i = 0; scene_name(i); i++) {
        Scene a, b, c;
        memset(&a, 0, sizeof a), memset(&b, 0, sizeof b), memset(&c, 0, sizeof c);
        assert_true(scene_make(&a, scene_name(i), &(Random){5}) &&
                    scene_make(&b, scene_name(i), &(Random){5}) &&
                    scene_make(&c, scene_name(i), &(Random){6}));
        assert_memory_equal(&a, &b, sizeof a);
        assert_true(memcmp(&a, &c, sizeof a) != 0);
        assert_true(a.object_count > 0 && a.light_count > 0);
    }
    Scene scene;
    check_clear();
    assert_false(scene_make(&scene, "no such scene", &(Random){1}));
    assert_non_null(strstr(check_message(), "\"table spot\""));
}

static float apart(vec3s a, vec3s b) {
    return glms_vec3_max(glms_vec3_abs(glms_vec3_sub(a, b)));
}

static bool is_own(vec3s color) {
    return glms_vec3_max(color) < PALETTE_DARKEST;
}

// Two objects look alike on purpose, or a wrong one in front is seen; six clear colours follow each other.
static void assert_told_apart(const Scene *scene, const char *name, unsigned seed) {
    for (int i = 0; i < scene->object_count; i++)
        for (int j = i + 1; j < scene->object_count && j < i + 6; j++) {
            vec3s a = scene->objects[i].color, b = scene->objects[j].color;
            if (!glms_vec3_eqv(a, b) && !(is_own(a) && is_own(b)) && apart(a, b) < 0.06f)
                fail_msg("%s, seed %u: objects %d and %d look alike", name, seed, i, j);
        }
}

static void test_palette(void **unused) {
    (void)unused;
    Scene scene;
    int repeated = 0;
    vec3s last = {0};
    for (unsigned seed = 1; seed <= 20; seed++) {
        for (int i = 0; scene_name(i); i++) {
            assert_true(scene_make(&scene, scene_name(i), &(Random){seed}));
            assert_told_apart(&scene, scene_name(i), seed);
        }
        assert_true(scene_make(&scene, "table spot", &(Random){seed}));
        repeated += apart(scene.objects[1].color, last) < 0.01f;
        last = scene.objects[1].color;
    }
    assert_true(repeated <= 5); // one of six colours, seldom as bright
    assert_true(scene_make(&scene, "dust gate", &(Random){1}) && is_own(scene.objects[0].color));
    palette_apply(&scene);
    assert_false(is_own(scene.objects[0].color));
    const Scene quiet = scene;
    palette_apply(&scene);
    assert_memory_equal(&scene, &quiet, sizeof quiet);
}

static void write_file(const char *folder, const char *name, const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, name);
    assert_true(files_write(path, text));
}

static void test_shader_files(void **unused) {
    (void)unused;
    char folder[FILES_PATH], mapped[400];
    ShaderSource source;
    check_clear();
    assert_true(files_make_temporary(folder));
    write_file(folder, "a.frag", "#version 410 core\n#include \"b.glsl\"\nlast\n");
    write_file(folder, "b.glsl", "one\ntwo\n");
    write_file(folder, "old.frag", "#version 330\n");
    write_file(folder, "up.frag", "#version 410 core\n#include \"../secret\"\n");
    shader_source_folders(folder, folder);
    assert_true(shader_source_load(&source, "a.frag"));
    assert_string_equal(source.text, "#version 410 core\n#line 1 1\none\ntwo\n#line 3 0\nlast\n");
    shader_source_map_log(&source, "1:2(5): error: x\n0:3(1): warning: y\nelse\n", mapped, sizeof mapped);
    assert_string_equal(mapped, "b.glsl:2:5: error: x\na.frag:3:1: warning: y\nelse\n");
    shader_source_destroy(&source);
    write_file(folder, "windows.frag", "\xef\xbb\xbf#version 410 core\r\n#include \"b.glsl\"\r\nlast\r\n");
    assert_true(shader_source_load(&source, "windows.frag"));
    assert_string_equal(source.text, "#version 410 core\r\n#line 1 1\none\ntwo\n#line 3 0\nlast\r\n");
    shader_source_destroy(&source);
    static const char *const refused[][2] = {
        {"old.frag", "old.frag:1: the first line must be: #version 410 core"},
        {"up.frag", "up.frag:2: #include takes one plain file name"},
        {"none.frag", "none.frag: there is no such shader file"}};
    for (int i = 0; i < 3; i++) {
        check_clear();
        assert_false(shader_source_load(&source, refused[i][0]));
        assert_non_null(strstr(check_message(), refused[i][1]));
    }
    files_remove(folder);
}

static Process *run(const char *script, const ProcessLimits *limits) {
    static Process process;
    char *arguments[] = {"sh", "-c", (char *)script, NULL}, *environment[] = {"PATH=/usr/bin:/bin", NULL};
    assert_true(process_start(&process, arguments, environment, "/", limits));
    return &process;
}

static void test_processes(void **unused) {
    (void)unused;
    const ProcessLimits short_life = {.wall_seconds = 1}, cpu = {.wall_seconds = 20, .cpu_seconds = 1};
    char reply[4];
    Process *process = run("cat >&3", &short_life);
    assert_true(process_exchange(process, "ping", 4, reply, 4));
    assert_memory_equal(reply, "ping", 4);
    process_stop(process);
    process = run("printf abc >&3; exit 7", &short_life); // one byte short
    assert_false(process_exchange(process, "x", 1, reply, 4));
    assert_true(process->state == PROCESS_ENDED && WEXITSTATUS(process->status) == 7);
    process_stop(process);
    process = run("sleep 30", &short_life);
    assert_false(process_exchange(process, "x", 1, reply, 4));
    assert_int_equal(process->state, PROCESS_TIMED_OUT);
    process_stop(process);
    process = run("while :; do :; done", &cpu);
    assert_false(process_exchange(process, "x", 1, reply, 4));
    assert_true(process->state == PROCESS_ENDED && WTERMSIG(process->status) == SIGXCPU);
    process_stop(process);
    process = run("yes", &(ProcessLimits){.wall_seconds = 20});
    assert_false(process_exchange(process, "x", 1, reply, 4));
    assert_int_equal(process->state, PROCESS_FLOODED);
    assert_int_equal(strlen(process->text), PROCESS_OUTPUT - 1);
    process_stop(process);
}

// The memory of a whole group is watched from outside.
static void test_memory(void **unused) {
    (void)unused;
    const ProcessLimits small = {.wall_seconds = 30, .resident_mib = 60},
                        large = {.wall_seconds = 30, .resident_mib = 2000};
    const char *const script =
        "{ head -c 150M /dev/zero; sleep 1; echo; } | tail -n 1 >/dev/null; printf done >&3";
    char reply[4];
    Process *process = run(script, &small);
    assert_false(process_exchange(process, "x", 1, reply, 4));
    assert_int_equal(process->state, PROCESS_TOO_LARGE);
    process_stop(process);
    process = run(script, &large);
    assert_true(process_exchange(process, "x", 1, reply, 4));
    process_stop(process);
}

static bool compiles(const char *folder, const char *text) {
    static char log[COMPILE_LOG], path[FILES_PATH];
    files_join(path, folder, "lab.c");
    assert_true(files_write(path, text));
    return compiler_build(folder, NULL, log);
}

// The flags of the precompiled header are those that labs are compiled with: else gcc reads given.h itself.
static void test_precompiled(void **unused) {
    (void)unused;
    char folder[FILES_PATH];
    assert_true(files_make_temporary(folder));
    assert_true(compiles(folder, "#ifdef GIVEN_NOT_PRECOMPILED\n#error slow\n#endif\nLab lab_table;\n"));
    assert_true(compiles(folder, "#include \"atlas.h\"\n#include \"lab.h\"\nLab lab_table;\n"));
    assert_false(compiles(folder, "#include \"lab.h\"\nLab lab_table = 1;\n"));
    files_remove(folder);
}

// Mirrored and flat objects are refused by name; a thin one, and one that is turned, are not.
static void test_scene_check(void **unused) {
    (void)unused;
    static const vec3s wrong[] = {{{-1, 1, 1}},
                                  {{-1, -1, -1}},
                                  {{0, 1, 1}},
                                  {{1, 1, NAN}},
                                  {{1, INFINITY, 1}}},
                       right[] = {{{-1, 1, -1}}, {{1, 1e-5f, 1}}, {{1000, 1, 0.001f}}};
    Scene scene = {.object_count = 2};
    scene.objects[0].world_from_object = glms_mat4_identity();
    for (unsigned i = 0; i < COUNT(wrong); i++) {
        scene.objects[1].world_from_object = glms_scale_make(wrong[i]);
        check_clear();
        assert_false(scene_check(&scene));
        assert_non_null(strstr(check_message(), i < 2 ? "object 1 is mirrored" : "object 1 is flat"));
    }
    check_clear();
    for (unsigned i = 0; i < COUNT(right); i++) {
        scene.objects[1].world_from_object = glms_scale_make(right[i]);
        assert_true(scene_check(&scene));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_scene_check), cmocka_unit_test(test_precompiled),
                                       cmocka_unit_test(test_random),      cmocka_unit_test(test_meshes),
                                       cmocka_unit_test(test_scenes),      cmocka_unit_test(test_palette),
                                       cmocka_unit_test(test_processes),   cmocka_unit_test(test_memory),
                                       cmocka_unit_test(test_shader_files)};
    return cmocka_run_group_tests_name("parts", tests, NULL, NULL);
}
