// frame: draws one frame of one of our labs to a PNG; the pictures of the handouts are made with it.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "compile/lab_folder.h"
#include "exam/exam.h"
#include "base/places.h"
#include "protocol/request_options.h"

#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: build/frame --lab NN --scene NAME [options] FILE.png\n"
    "  --view V          picture (default), visibility or a stage of the lab\n"
    "  --seed N          variant of the scene (default 1)\n"
    "  --size WxH        default 480x360\n"
    "  --knob NAME=VALUE may be repeated\n"
    "  --skeleton        nothing solved\n"
    "  --up-to TASK      solved up to this task\n"
    "  --without TASK    all solved but this task\n"
    "  --submission DIR  a student's lab, for instance labs/03-shadow-map\n"
    "  --job DIR         of it: write all that a worker needs to DIR, and draw nothing (no FILE)\n"
    "  --mistake NAME    the solution with a mistake of mistakes.json\n"
    "  --context C       osmesa (default) or egl\n";

typedef struct Options {
    const char *lab, *scene, *mistake, *submission, *job;
    Solved solved;
    uint64_t seed;
    Request request;
    ContextKind context;
} Options;

static bool take_option(Options *options, int option, char *value) {
    switch (option) {
    case 'l':
        options->lab = value;
        return true;
    case 'n':
        options->scene = value;
        return true;
    case 'v':
        snprintf(options->request.view, sizeof options->request.view, "%s", value);
        return true;
    case 's':
        options->seed = strtoull(value, NULL, 10);
        return true;
    case 'z':
        return request_take_size(&options->request, value);
    case 'k':
        return request_take_knob(&options->request, value);
    case 'e':
        options->solved = (Solved){SOLVED_NONE, NULL};
        return true;
    case 'u':
        options->solved = (Solved){SOLVED_UP_TO, value};
        return true;
    case 'w':
        options->solved = (Solved){SOLVED_ALL_BUT, value};
        return true;
    case 'S':
        options->submission = value;
        return true;
    case 'j':
        options->job = value;
        return true;
    case 'm':
        options->mistake = value;
        return true;
    case 'c':
        return context_parse(&options->context, value);
    default:
        return check_fail("unknown option, or one without its value");
    }
}

static bool parse(Options *options, int count, char **arguments) {
    static const struct option table[] = {
        {"lab", required_argument, NULL, 'l'},        {"scene", required_argument, NULL, 'n'},
        {"view", required_argument, NULL, 'v'},       {"seed", required_argument, NULL, 's'},
        {"size", required_argument, NULL, 'z'},       {"knob", required_argument, NULL, 'k'},
        {"skeleton", no_argument, NULL, 'e'},         {"up-to", required_argument, NULL, 'u'},
        {"without", required_argument, NULL, 'w'},    {"mistake", required_argument, NULL, 'm'},
        {"submission", required_argument, NULL, 'S'}, {"job", required_argument, NULL, 'j'},
        {"context", required_argument, NULL, 'c'},    {0}};
    *options = (Options){.seed = 1, .request = {.magic = PROTOCOL_MAGIC, .width = 480, .height = 360}};
    strcpy(options->request.view, VIEW_PICTURE);
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;)
        if (!take_option(options, option, optarg))
            return false;
    if (options->job && !options->submission)
        return check_fail("--job needs --submission");
    return (options->lab && options->scene && optind == count - (options->job ? 0 : 1)) ||
           check_fail("--lab, --scene and one FILE.png (or --job) are needed");
}

// Compiles the student's lab into `folder`; what gcc says is printed.
static bool take_submission(const char *folder, const Rubric *rubric, const char *submission) {
    static char log[COMPILE_LOG];
    bool ok = lab_folder_submission(folder, rubric, submission, NULL, log);
    if (log[0])
        fprintf(stderr, "%s\n", log);
    return ok;
}

static bool write_request(const Request *request, const char *folder) {
    char path[FILES_PATH];
    files_join(path, folder, "request");
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(request, sizeof *request, 1, file) == 1;
    if (file && fclose(file) != 0)
        ok = false;
    return ok || check_fail("%s cannot be written: %s", path, strerror(errno));
}

static bool write_job(Options *options, const Rubric *rubric) {
    char folder[FILES_PATH];
    Random random = {options->seed};
    snprintf(folder, sizeof folder, "%.4000s/", options->job);
    return scene_make(&options->request.scene, options->scene, &random) && files_make_folder(folder) &&
           take_submission(options->job, rubric, options->submission) &&
           write_request(&options->request, options->job);
}

// Draws the student's lab with a worker of its own.
static bool draw_submission(const Options *options, const Rubric *rubric, Image *image, Reply *reply) {
    static WorkerClient client;
    client = (WorkerClient){.trust = TRUST_NOBODY, .context = options->context, .seconds = 60};
    bool ok =
        files_make_temporary(client.folder) && take_submission(client.folder, rubric, options->submission);
    const DrawResult drawn = ok ? worker_client_draw(&client, &options->request, image, reply) : DRAW_LOST;
    worker_client_stop(&client);
    files_remove(client.folder);
    return ok && (drawn == DRAW_OK || check_fail("%s", reply->message));
}

static bool draw(Options *options, const Rubric *rubric, const char *path) {
    static Reply reply;
    Image image = {0};
    Painters painters = {.rubric = rubric, .context = options->context};
    Random random = {options->seed};
    const Change *change = options->mistake ? rubric_mistake(rubric, options->mistake) : NULL;
    bool ok = (change || !options->mistake) && scene_make(&options->request.scene, options->scene, &random);
    const Painter *painter =
        ok && !options->submission ? painters_get(&painters, options->solved, change) : NULL;
    ok = ok && options->submission
             ? draw_submission(options, rubric, &image, &reply)
             : painter && painters_draw(&painters, painter, &options->request, &image, &reply);
    if (ok && reply.message[0])
        fprintf(stderr, "frame: %s\n", reply.message);
    ok = ok && (reply.drawn || check_fail("nothing was drawn")) && image_write_png(&image, path);
    image_destroy(&image);
    painters_destroy(&painters);
    return ok;
}

int main(int count, char **arguments) {
    static Options options;
    if (!parse(&options, count, arguments)) {
        fprintf(stderr, "frame: %s\n%s", check_message(), usage);
        return 2;
    }
    signal(SIGPIPE, SIG_IGN);
    char folder[FILES_PATH];
    Rubric rubric = {0};
    bool found = places_find_lab(folder, options.lab) || check_fail("there is no lab \"%s\"", options.lab);
    bool known = found && rubric_load(&rubric, folder);
    bool ok =
        known && (options.job ? write_job(&options, &rubric) : draw(&options, &rubric, arguments[count - 1]));
    if (!ok)
        fprintf(stderr, "frame: %s\n", check_message());
    rubric_destroy(&rubric);
    return ok ? 0 : found && !known ? 3 : 1;
}
