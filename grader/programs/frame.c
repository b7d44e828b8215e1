// frame: draws one frame of one of our labs to a PNG; the pictures of the handouts are made with it.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "compile/lab_folder.h"
#include "exam/exam.h"
#include "pages/picture_colors.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "protocol/description.h"
#include "protocol/request_options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct FrameCommand {
    char lab[3];
    const char *scene, *mistake, *submission, *job, *file;
    Solved solved;
    uint64_t seed;
    Request request;
    ContextKind context;
    int fine; // so many times as wide and high it is drawn
    bool quiet;
    bool misfit; // a knob of the command line is none of the lab's, or out of its range
} FrameCommand;

enum { MOST_FINE = 4 };

static bool take_skeleton(void *target, const char *none) {
    (void)none;
    *(Solved *)target = (Solved){SOLVED_NONE, NULL};
    return true;
}

static bool take_up_to(void *target, const char *text) {
    const char *task;
    if (!option_task(&task, text))
        return false;
    *(Solved *)target = (Solved){SOLVED_UP_TO, task};
    return true;
}

static bool take_without(void *target, const char *text) {
    const char *task;
    if (!option_task(&task, text))
        return false;
    *(Solved *)target = (Solved){SOLVED_ALL_BUT, task};
    return true;
}

static bool take_fine(void *target, const char *text) {
    return option_whole(target, text, 1, MOST_FINE);
}

static bool take_colors(void *target, const char *text) {
    *(bool *)target = strcmp(text, "quiet") == 0;
    return *(bool *)target || strcmp(text, "own") == 0 || check_fail("takes own or quiet, not \"%s\"", text);
}

#define AT(field) offsetof(FrameCommand, field)
static const Option options[] = {
    {"lab", 0, "NN", "the lab", AT(lab), option_lab},
    {"scene", 0, "NAME", "the scene", AT(scene), option_text},
    {"view", 0, "V", "picture (default), visibility or a stage of the lab", AT(request), request_take_view},
    {"seed", 0, "N", "variant of the scene (default 1)", AT(seed), option_seed},
    {"size", 0, "WxH", "default 480x360", AT(request), request_take_size},
    {"knob", 0, "NAME=VALUE", "of the lab, within its range; may be repeated", AT(request),
     request_take_knob},
    {"skeleton", 0, NULL, "nothing solved", AT(solved), take_skeleton},
    {"up-to", 0, "TASK", "solved up to this task", AT(solved), take_up_to},
    {"without", 0, "TASK", "all solved but this task", AT(solved), take_without},
    {"submission", 0, "DIR", "a student's lab, for instance labs/03-shadow-map", AT(submission), option_text},
    {"job", 0, "DIR", "of it: write all that a worker needs to DIR, and draw nothing (no FILE)", AT(job),
     option_text},
    {"mistake", 0, "NAME", "the solution with a mistake of mistakes.json", AT(mistake), option_text},
    {"fine", 0, "N", "smooth edges: drawn N times as large (1 to 4), and N x N pixels become one", AT(fine),
     take_fine},
    {"colors", 0, "own|quiet", "those of the variant (default), or the few of the handouts' pictures",
     AT(quiet), take_colors},
    {"context", 0, "C", "osmesa or egl (default: the first that is here)", AT(context), option_context},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    FrameCommand *command = settings;
    if (command->job && !command->submission)
        return check_fail("--job needs --submission");
    if (command->job && operands->count > 0)
        return check_fail("\"%s\": with --job there is no FILE.png", operands->texts[0]);
    command->file = operands->texts[0]; // NULL behind the last
    if (command->fine * command->request.width > PROTOCOL_MAX_SIZE ||
        command->fine * command->request.height > PROTOCOL_MAX_SIZE)
        return check_fail("--fine %d makes the picture larger than %d pixels", command->fine,
                          PROTOCOL_MAX_SIZE);
    return (command->lab[0] && command->scene && (command->job || command->file)) ||
           check_fail("--lab, --scene and one FILE.png (or --job) are needed");
}

static const CommandLine command_line = {
    .program = "frame",
    .forms = "--lab NN --scene NAME [options] FILE.png\n--lab NN --scene NAME --submission DIR --job DIR "
             "[options]",
    .about = "Draws one frame of a lab to a PNG.\n",
    .options = options,
    .operand = "FILE.png",
    .most = 1,
    .check = check,
};

// Compiles the student's lab into `folder`; what gcc says is printed.
static bool take_submission(const char *folder, const Rubric *rubric, const char *submission) {
    static char log[COMPILE_LOG];
    bool ok = lab_folder_submission(folder, rubric, submission, NULL, log);
    if (log[0])
        fprintf(stderr, "%s\n", log);
    return ok;
}

// Do the knobs fit the lab that this worker has loaded, or that lies in `folder` for a worker of several?
static bool check_knobs(FrameCommand *command, WorkerClient *client, const char *folder) {
    static Request request;
    static Reply reply;
    static Description lab;
    if (command->request.knob_count == 0)
        return true;
    request = command->request;
    snprintf(request.folder, sizeof request.folder, "%.*s", (int)sizeof request.folder - 1, folder);
    if (worker_client_describe(client, &request, &lab, &reply) != DRAW_OK)
        return check_fail("the lab does not tell its knobs: %s", reply.message);
    command->misfit = !description_fits(&lab, &command->request);
    return !command->misfit;
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

static bool make_scene(FrameCommand *command) {
    Random random = {command->seed};
    const bool ok = scene_make(&command->request.scene, command->scene, &random);
    if (ok && command->quiet)
        picture_colors_apply(&command->request.scene);
    return ok;
}

static bool write_job(FrameCommand *command, const Rubric *rubric) {
    char folder[FILES_PATH];
    static WorkerClient client;
    client = (WorkerClient){.trust = TRUST_NOBODY, .context = command->context, .seconds = 60};
    snprintf(client.folder, sizeof client.folder, "%.4000s", command->job);
    snprintf(folder, sizeof folder, "%.4000s/", command->job);
    const bool ok = make_scene(command) && files_make_folder(folder) &&
                    take_submission(command->job, rubric, command->submission) &&
                    check_knobs(command, &client, command->job) &&
                    write_request(&command->request, command->job);
    worker_client_stop(&client);
    return ok;
}

// Draws the student's lab with a worker of its own.
static bool draw_submission(FrameCommand *command, const Rubric *rubric, Image *image, Reply *reply) {
    static WorkerClient client;
    client = (WorkerClient){.trust = TRUST_NOBODY, .context = command->context, .seconds = 60};
    bool ok = files_make_temporary(client.folder) &&
              take_submission(client.folder, rubric, command->submission) &&
              check_knobs(command, &client, client.folder);
    const DrawResult drawn = ok ? worker_client_draw(&client, &command->request, image, reply) : DRAW_LOST;
    worker_client_stop(&client);
    files_remove(client.folder);
    return ok && (drawn == DRAW_OK || check_fail("%s", reply->message));
}

static bool draw(FrameCommand *command, const Rubric *rubric, const char *path) {
    static Reply reply;
    Image image = {0};
    Painters painters = {.rubric = rubric, .context = command->context};
    const Change *change = command->mistake ? rubric_mistake(rubric, command->mistake) : NULL;
    command->request.width *= command->fine;
    command->request.height *= command->fine;
    bool ok = (change || !command->mistake) && make_scene(command);
    const Painter *painter =
        ok && !command->submission ? painters_get(&painters, command->solved, change) : NULL;
    ok = ok && command->submission ? draw_submission(command, rubric, &image, &reply)
                                   : painter && check_knobs(command, &painters.client, painter->folder) &&
                                         painters_draw(&painters, painter, &command->request, &image, &reply);
    if (ok && reply.message[0])
        fprintf(stderr, "frame: %s\n", reply.message);
    Image shown = {0};
    ok = ok && (reply.drawn || check_fail("nothing was drawn")) &&
         image_shrink(&shown, &image, command->fine) && image_write_png(&shown, path);
    image_destroy(&image);
    image_destroy(&shown);
    painters_destroy(&painters);
    return ok;
}

int main(int count, char **arguments) {
    static FrameCommand command = {
        .seed = 1,
        .fine = 1,
        .request = {.magic = PROTOCOL_MAGIC, .width = 480, .height = 360, .view = VIEW_PICTURE}};
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &command.context);
    char folder[FILES_PATH];
    Rubric rubric = {0};
    bool found = places_find_lab(folder, command.lab), known = found && rubric_load(&rubric, folder);
    bool ok = known && (command.job ? write_job(&command, &rubric) : draw(&command, &rubric, command.file));
    if (!ok)
        fprintf(stderr, "frame: %s\n", check_message());
    rubric_destroy(&rubric);
    return ok ? 0 : command.misfit ? 2 : found && !known ? 3 : 1;
}
