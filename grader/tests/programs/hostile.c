// hostile bwrap|landlock|outside FOLDER: compiles and runs each submission of tests/hostile/ by this route
// and holds what happens against the file's line "// must:". Outside, a file with the line "// outside:
// through" must get through: else its attack proves nothing. FOLDER is empty and for the temporary files;
// afterwards nobody and nothing may be left. Ends with `N passed, N failed`.
//
// must: drawn               the frame came, and no attack got through
//       timeout             stopped after its time
//       nan                 the frame came, and all its pixels are marked as no numbers
//       lost WORDS          no frame, and the message holds the words
//       uncompiled WORDS    no library, and the compiler's words or ours hold them (also WORDS|OTHER WORDS)
#include "scene/check.h"
#include "scene/count.h"
#include "exam/worker_client.h"
#include "compile/compiler.h"
#include "base/places.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "exam/nursery_client.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const float SECONDS = 1; // of those that must be stopped

static struct {
    const Jail *jail; // NULL: outside
    bool nursery;     // the workers are forked, not started
    char parts[FILES_PATH], secret[FILES_PATH], result[FILES_PATH], root[FILES_PATH];
    char folder[FILES_PATH]; // of all temporary files
    int passed, failed;
} suite;

typedef struct AttackCase {
    char name[64], must[128];
    bool outside;
    char *text; // owned
    char log[COMPILE_LOG];
    WorkerClient client;
    Reply reply;
    Image image;
} AttackCase;

static void verdict(const char *name, const char *trouble, const char *words) {
    if (trouble)
        printf("FAILED: %s: %s: %.600s\n", name, trouble, words);
    suite.failed += trouble != NULL;
    suite.passed += trouble == NULL;
    fflush(stdout);
}

static char *read_part(const char *name) {
    char path[FILES_PATH];
    files_join(path, suite.parts, name);
    return files_read(path, 1 << 20);
}

static bool find_line(const char *text, const char *key, char *value, size_t size) {
    const char *at = strstr(text, key);
    snprintf(value, size, "%.*s", at ? (int)strcspn(at + strlen(key), "\n") : 0, at ? at + strlen(key) : "");
    return at != NULL;
}

static bool case_read(AttackCase *one, const char *file) {
    char outside[16], by_route[32];
    snprintf(by_route, sizeof by_route,
             "// %s must: ", suite.jail ? jail_route_name(suite.jail->route) : "-");
    snprintf(one->name, sizeof one->name, "%.*s", (int)strcspn(file, "."), file);
    one->text = read_part(file);
    if (!one->text)
        return false;
    if (!find_line(one->text, by_route, one->must, sizeof one->must))
        find_line(one->text, "// must: ", one->must, sizeof one->must);
    find_line(one->text, "// outside: ", outside, sizeof outside);
    one->outside = strcmp(outside, "through") == 0;
    return one->must[0] || check_fail("%s has no line \"// must:\"", file);
}

static bool write_lab(const AttackCase *one) {
    char path[FILES_PATH], host[256] = "";
    gethostname(host, sizeof host - 1);
    char *head = read_part("head.part"), *tail = read_part("tail.part");
    files_join(path, one->client.folder, "lab.c");
    FILE *file = head && tail ? fopen(path, "w") : NULL;
    if (file) {
        fprintf(file,
                "#define ROOT \"%s\"\n#define SECRET \"%s\"\n#define HOST \"%s\"\n#define RESULT "
                "\"%s\"\n#define FOLDER \"%s\"\n"
                "#define GRADER %ld\n#define OUTSIDE %d\n#define REPLY_BYTES %zu\n"
                "#define ROOT_SOLUTION \"%s/solutions/03-shadow-map/lab.c\"\n"
                "#define ROOT_RELATIVE \"../../../../../../../..%s/solutions/03-shadow-map/lab.c\"\n"
                "#define QUOTED_SOLUTION \"\\\"%s/solutions/03-shadow-map/lab.c\\\"\"\n"
                "%s#line 1 \"%s.c\"\n%s%s",
                suite.root, suite.secret, host, suite.result, suite.folder, (long)getpid(),
                suite.jail == NULL, sizeof(Reply), suite.root, suite.root, suite.root, head, one->name,
                one->text, tail);
        fclose(file);
    }
    free(head);
    free(tail);
    return file != NULL;
}

static bool write_shader(const AttackCase *one) {
    char name[80], path[FILES_PATH];
    snprintf(name, sizeof name, "%s.frag", one->name);
    files_join(path, suite.parts, name);
    char *text = read_part(files_exists(path) ? name : "plain.frag");
    files_join(path, one->client.folder, "attack.frag");
    bool ok = text && files_write(path, text);
    free(text);
    return ok;
}

// One of the texts, which stand between bars.
static bool said_one_of(const AttackCase *one, const char *texts) {
    char list[128], *rest = list;
    snprintf(list, sizeof list, "%s", texts);
    bool said = false;
    for (const char *text; (text = strsep(&rest, "|"));)
        said = said || strstr(one->log, text) || strstr(check_message(), text);
    return said;
}

static void judge_compilation(const AttackCase *one, bool compiled) {
    bool stopped = !compiled && said_one_of(one, one->must + strlen("uncompiled "));
    if (suite.jail)
        verdict(one->name, stopped ? NULL : "it is not stopped where it should be", one->log);
    else if (one->outside)
        verdict(one->name, stopped ? "outside the compiler does not get through" : NULL, one->log);
}

static bool all_marked(const Image *image) {
    for (size_t at = 3; at < image_bytes(image); at += 4)
        if (image->rgba[at] != 0)
            return false;
    return true;
}

static const char *judge_frame(const AttackCase *one, DrawResult result) {
    const char *message = one->reply.message;
    if (!suite.jail)
        return strstr(message, "GOT THROUGH") ? NULL : "outside its attack does not get through";
    if (strstr(message, "GOT THROUGH"))
        return "an attack got through";
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        if (!(one->reply.milliseconds[i] >= 0 && isfinite(one->reply.milliseconds[i]) &&
              one->reply.gpu_milliseconds[i] >= 0 && isfinite(one->reply.gpu_milliseconds[i])))
            return "its times are no times";
    if (memchr(one->reply.renderer, '\0', sizeof one->reply.renderer) == NULL)
        return "the renderer's name does not end";
    if (strcmp(one->must, "timeout") == 0)
        return result == DRAW_TIMEOUT ? NULL : "it was not stopped after its time";
    if (strncmp(one->must, "lost ", 5) == 0)
        return result == DRAW_LOST && strstr(message, one->must + 5) ? NULL : "it is not lost as it must be";
    if (result != DRAW_OK || message[0])
        return "its frame did not come";
    if (strcmp(one->must, "nan") == 0)
        return all_marked(&one->image) ? NULL : "some pixels pass for numbers";
    return strcmp(one->must, "drawn") == 0 && one->image.rgba[3] == 255 ? NULL : "unknown: must";
}

static void run_frame(AttackCase *one) {
    static Request request;
    request = (Request){.magic = PROTOCOL_MAGIC, .width = 32, .height = 24, .view = VIEW_PICTURE};
    bool made = scene_make(&request.scene, "table spot", &(Random){1});
    INVARIANT(made);
    if (strcmp(one->must, "timeout") == 0)
        one->client.seconds = SECONDS;
    DrawResult result = worker_client_draw(&one->client, &request, &one->image, &one->reply);
    pid_t group = one->client.process.pid;
    worker_client_stop(&one->client);
    const char *trouble = judge_frame(one, result);
    if (!trouble && group > 0 && kill(-group, 0) == 0)
        trouble = "processes are left";
    verdict(one->name, trouble, one->reply.message);
}

static void run_case(const char *file, void *context) {
    static AttackCase one;
    (void)context;
    if (!strstr(file, ".c"))
        return;
    one = (AttackCase){
        .client = {.trust = TRUST_NOBODY, .jail = suite.jail, .quick_shaders = suite.nursery, .seconds = 20}};
    check_clear();
    bool ok = case_read(&one, file);
    bool left_out = ok && ((!suite.jail && !one.outside) ||
                           (getenv("SHADOW_LAB_QUICK") && strstr(one.text, "// slow\n")));
    ok = ok && !left_out;
    if (ok && files_make_temporary(one.client.folder)) {
        ok = write_lab(&one) && write_shader(&one);
        bool compiled = ok && compiler_build(one.client.folder, suite.jail, one.log);
        if (strncmp(one.must, "uncompiled ", 11) == 0)
            judge_compilation(&one, compiled);
        else if (compiled)
            run_frame(&one);
        else
            verdict(one.name, check_message(), one.log);
        files_remove(one.client.folder);
    } else if (!left_out) {
        verdict(file, check_message(), "");
    }
    image_destroy(&one.image);
    free(one.text);
}

// Does a process have a file of the folder open, mapped, or as its working folder?
static bool holds(const char *pid, const char *folder) {
    char path[FILES_PATH], target[FILES_PATH] = "", line[2 * FILES_PATH];
    bool found = false;
    snprintf(path, sizeof path, "/proc/%.32s/cwd", pid);
    if (readlink(path, target, sizeof target - 1) > 0 && strstr(target, folder))
        return true;
    snprintf(path, sizeof path, "/proc/%.32s/maps", pid);
    FILE *maps = fopen(path, "r");
    while (maps && fgets(line, sizeof line, maps))
        found = found || strstr(line, folder);
    if (maps)
        fclose(maps);
    return found;
}

static void count_process(const char *name, void *context) {
    int *count = context;
    *count += name[0] >= '1' && name[0] <= '9' && holds(name, suite.folder);
}

static void count_file(const char *name, void *context) {
    int *count = context;
    *count += strcmp(name, "secret") != 0 && strcmp(name, "result") != 0;
}

static void judge_leftovers(void) {
    static const char *const places[] = {"/tmp", "/var/tmp", "/dev/shm", "/run", "/", "/home"};
    int processes = 0, files = 0, strays = 0;
    bool listed =
        files_list("/proc", count_process, &processes) && files_list(suite.folder, count_file, &files);
    INVARIANT(listed);
    for (unsigned i = 0; i < COUNT(places); i++) {
        char path[FILES_PATH];
        files_join(path, places[i], "shadow-lab-hostile");
        strays += files_exists(path);
        if (!suite.jail)
            remove(path);
    }
    char *result = files_read(suite.result, 100);
    bool changed = !result || strcmp(result, "no result yet") != 0;
    free(result);
    if (!suite.jail)
        return;
    verdict("afterwards", processes ? "processes are left" : NULL, "");
    verdict("afterwards", files ? "temporary files are left" : NULL, "");
    verdict("afterwards", strays ? "files are left elsewhere" : NULL, "");
    verdict("afterwards", changed ? "the result was overwritten" : NULL, "");
}

static bool prepare(void) {
    if (!files_make_temporary(suite.folder))
        return false;
    places_path(suite.parts, "grader/tests/hostile");
    places_path(suite.root, "");
    suite.root[strlen(suite.root) - 1] = '\0';
    files_join(suite.secret, suite.folder, "secret");
    files_join(suite.result, suite.folder, "result");
    setenv("TMPDIR", suite.folder, 1);
    return files_write(suite.secret, "secret") && files_write(suite.result, "no result yet") &&
           chmod(suite.secret, 0666) == 0 && chmod(suite.result, 0666) == 0 && chmod(suite.folder, 0755) == 0;
}

int main(int count, char **arguments) {
    static Jail jail;
    JailRoute route = JAIL_BWRAP;
    bool outside = count == 2 && strcmp(arguments[1], "outside") == 0;
    signal(SIGPIPE, SIG_IGN);
    suite.nursery = count == 2 && strcmp(arguments[1], "nursery") == 0;
    bool ok = count == 2 && (outside || suite.nursery || jail_take_route(&route, arguments[1])) &&
              prepare() && (outside || jail_create(&jail, route));
    suite.jail = outside ? NULL : &jail;
    ok = ok && files_list(suite.parts, run_case, NULL);
    if (!ok)
        fprintf(stderr, "hostile: %s\n", check_message());
    const bool forked = nursery_stop();
    verdict("the nursery", forked != suite.nursery ? "it was there, or not" : NULL, "");
    jail_destroy(&jail);
    if (ok)
        judge_leftovers();
    files_remove(suite.folder);
    printf("%d passed, %d failed\n", suite.passed, suite.failed + !ok);
    return ok && suite.failed == 0 ? 0 : 1;
}
