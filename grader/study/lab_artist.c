#include "study/lab_artist.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/places.h"

#include <stdlib.h>

enum { SECONDS = 600 }; // that a submission may draw for a study

static bool load(Artist *artist, const char *id) {
    char folder[FILES_PATH];
    *artist = (Artist){0};
    return (home_find_lab(folder, id) || check_fail("there is no lab \"%s\" in solutions/", id)) &&
           rubric_load(&artist->rubric, folder);
}

bool artist_open(Artist *artist, const char *id) {
    if (!load(artist, id))
        return false;
    artist->roster.rubric = &artist->rubric;
    return artist_change(artist, NULL);
}

static bool derive(Artist *artist, const char *folder) {
    char log[COMPILE_LOG] = "";
    return files_make_temporary(artist->client.folder) &&
           (derive_submission(artist->client.folder, &artist->rubric, folder, artist->client.jail, log) ||
            check_fail("%s", log[0] ? log : "the submission does not compile"));
}

bool artist_open_submission(Artist *artist, const char *id, const char *submission, const Jail *jail) {
    char folder[FILES_PATH];
    if (!load(artist, id))
        return false;
    if (!home_find_lab_in(folder, submission, id))
        files_join(folder, submission, ".");
    artist->client = (Client){.trust = TRUST_NOBODY, .jail = jail, .seconds = SECONDS};
    return derive(artist, folder);
}

bool artist_adapt(Artist *artist, const Change *change) {
    INVARIANT(!artist->painter && !artist->client.started);
    bool ok = true;
    for (int i = 0; ok && i < change->edit_count; i++) {
        char path[FILES_PATH];
        files_join(path, artist->client.folder, change->edits[i].file);
        char *text = files_read(path, DERIVE_MAX_FILE);
        char *edited = text ? source_edit(text, &change->edits[i]) : NULL;
        check_clear();
        ok = !edited || files_write(path, edited);
        free(text);
        free(edited);
    }
    return ok;
}

bool artist_change(Artist *artist, const Change *change) {
    INVARIANT(artist->roster.rubric);
    const Painter *painter = roster_get(&artist->roster, (Solved){SOLVED_ALL, NULL}, change);
    artist->painter = painter ? painter : artist->painter;
    return painter != NULL;
}

bool artist_draw(Artist *artist, const Request *request, Image *image, Reply *reply) {
    if (artist->painter && !roster_draw(&artist->roster, artist->painter, request, image, reply))
        return false;
    if (!artist->painter)
        client_draw(&artist->client, request, image, reply);
    return reply->drawn || check_fail("lab %s drew nothing: %s", artist->rubric.id, reply->message);
}

void artist_close(Artist *artist) {
    client_stop(&artist->client);
    if (artist->client.folder[0])
        files_remove(artist->client.folder);
    roster_destroy(&artist->roster);
    rubric_destroy(&artist->rubric);
    *artist = (Artist){0};
}
