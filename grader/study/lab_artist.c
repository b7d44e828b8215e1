// Starts whoever draws a lab for the study (the solution, with or without a change, or a submission), each
// under the conditions that measuring asks for.
#include "study/lab_artist.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "compile/lab_folder.h"
#include "base/places.h"

#include <stdlib.h>
#include <string.h>

enum { SECONDS = 600 }; // that a submission may draw for a study

static bool load(LabArtist *artist, const char *id) {
    char folder[FILES_PATH];
    *artist = (LabArtist){0};
    return (places_find_lab(folder, id) || check_fail("there is no lab \"%s\" in solutions/", id)) &&
           rubric_load(&artist->rubric, folder);
}

static bool take_solution(LabArtist *artist) {
    artist->roster.rubric = &artist->rubric;
    return lab_artist_change(artist, NULL);
}

bool lab_artist_open(LabArtist *artist, const char *id) {
    return load(artist, id) && take_solution(artist);
}

bool lab_artist_open_measured(LabArtist *artist, const char *id, ContextKind context) {
    if (!load(artist, id))
        return false;
    artist->roster.context = context;
    artist->roster.measures = true;
    return take_solution(artist);
}

// In one line: the compiler's first error.
static bool tell_compiler(const char *log) {
    const char *error = strstr(log, "error: ");
    while (error && error > log && error[-1] != '\n')
        error--;
    check_clear();
    return check_fail("the submission does not compile: %.*s", (int)strcspn(error ? error : log, "\n"),
                      error ? error : log);
}

static bool derive(LabArtist *artist, const char *folder) {
    char log[COMPILE_LOG] = "";
    return files_make_temporary(artist->client.folder) &&
           (lab_folder_submission(artist->client.folder, &artist->rubric, folder, artist->client.jail, log) ||
            (log[0] && tell_compiler(log)));
}

bool lab_artist_open_submission(LabArtist *artist, const char *id, const char *submission, const Jail *jail,
                                ContextKind context) {
    char folder[FILES_PATH];
    if (!load(artist, id))
        return false;
    places_lab_of(folder, submission, id);
    artist->client = (WorkerClient){.trust = TRUST_NOBODY,
                                    .jail = jail,
                                    .context = context,
                                    .hardware = !jail && context == CONTEXT_EGL,
                                    .seconds = SECONDS};
    return derive(artist, folder);
}

bool lab_artist_adapt(LabArtist *artist, const Change *change) {
    INVARIANT(!artist->painter && !artist->client.started);
    bool ok = true;
    for (int i = 0; ok && i < change->edit_count; i++) {
        char path[FILES_PATH];
        files_join(path, artist->client.folder, change->edits[i].file);
        char *text = files_read(path, DERIVE_MAX_FILE);
        char *edited = text ? task_blocks_edit(text, &change->edits[i]) : NULL;
        check_clear();
        ok = !edited || files_write(path, edited);
        free(text);
        free(edited);
    }
    return ok;
}

bool lab_artist_change(LabArtist *artist, const Change *change) {
    INVARIANT(artist->roster.rubric);
    const Painter *painter = painters_get(&artist->roster, (Solved){SOLVED_ALL, NULL}, change);
    artist->painter = painter ? painter : artist->painter;
    return painter != NULL;
}

void lab_artist_leave_out(LabArtist *artist, Scene *scene) {
    static const float POINT = 1e-4f; // world units: less than a pixel and a texel
    for (int i = 0; i < scene->object_count; i++) {
        if (!(artist->without >> i & 1))
            continue;
        mat4s *world = &scene->objects[i].world_from_object;
        for (int axis = 0; axis < 3; axis++) {
            const vec3s unit = glms_vec3_normalize(glms_vec3(world->col[axis]));
            world->col[axis] = glms_vec4(glms_vec3_scale(unit, POINT), 0);
        }
    }
}

bool lab_artist_draw(LabArtist *artist, const Request *asked, Image *image, Reply *reply) {
    static _Thread_local Request changed;
    const Request *request = asked;
    if (asked->scene.object_count > artist->most_objects)
        artist->most_objects = asked->scene.object_count;
    if (artist->without) {
        changed = *asked;
        lab_artist_leave_out(artist, &changed.scene);
        request = &changed;
    }
    if (artist->painter && !painters_draw(&artist->roster, artist->painter, request, image, reply))
        return false;
    if (!artist->painter)
        worker_client_draw(&artist->client, request, image, reply);
    memcpy(artist->renderer, reply->renderer, sizeof artist->renderer);
    return reply->drawn || check_fail("lab %s drew nothing: %s", artist->rubric.id, reply->message);
}

const int32_t *lab_artist_pass_kinds(LabArtist *artist) {
    static Request request;
    static Reply reply;
    INVARIANT(artist->painter);
    if (artist->table.pass_count > 0)
        return artist->table.pass_kinds;
    request = (Request){.magic = PROTOCOL_MAGIC, .width = 1, .height = 1};
    memcpy(request.folder, artist->painter->folder, sizeof request.folder);
    if (worker_client_describe(&artist->roster.client, &request, &artist->table, &reply) == DRAW_OK)
        return artist->table.pass_kinds;
    check_fail("lab %s does not tell its passes: %s", artist->rubric.id, reply.message);
    return NULL;
}

void lab_artist_close(LabArtist *artist) {
    worker_client_stop(&artist->client);
    worker_client_stop(&artist->counter);
    if (artist->client.folder[0])
        files_remove(artist->client.folder);
    painters_destroy(&artist->roster);
    rubric_destroy(&artist->rubric);
    *artist = (LabArtist){0};
}
