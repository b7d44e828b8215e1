#include "crew.h"

#include "check.h"
#include "derive.h"
#include "hash.h"

#include <stdlib.h>
#include <string.h>

static Artist *hire(const Crew *crew, const Method *method) {
    Artist *artist = calloc(1, sizeof *artist);
    INVARIANT(artist);
    if (method->submission ? artist_open_submission(artist, method->lab, crew->submission, crew->jail)
                           : artist_open(artist, method->lab))
        return artist;
    artist_close(artist);
    free(artist);
    return NULL;
}

Artist *crew_get(Crew *crew, const Method *method) {
    if (method->submission)
        return crew->submitted ? crew->submitted : (crew->submitted = hire(crew, method));
    for (int i = 0; i < crew->count; i++)
        if (strcmp(crew->ours[i]->rubric.id, method->lab) == 0)
            return crew->ours[i];
    INVARIANT(crew->count < CREW_MOST);
    Artist *artist = hire(crew, method);
    if (artist)
        crew->ours[crew->count++] = artist;
    return artist;
}

uint64_t crew_key(const Artist *artist) {
    uint64_t hash = HASH_START;
    if (artist->painter) // the folder's name is one
        return hash_bytes(hash, artist->painter->folder, strlen(artist->painter->folder));
    for (int i = 0; i < artist->rubric.file_count; i++) {
        char path[FILES_PATH];
        files_join(path, artist->client.folder, artist->rubric.files[i]);
        char *text = files_read(path, DERIVE_MAX_FILE);
        hash = text ? hash_bytes(hash, text, strlen(text) + 1) : hash;
        free(text);
    }
    return hash;
}

static void let_go(Artist *artist) {
    if (artist)
        artist_close(artist);
    free(artist);
}

void crew_dismiss(Crew *crew) {
    for (int i = 0; i < crew->count; i++)
        let_go(crew->ours[i]);
    let_go(crew->submitted);
    crew->submitted = NULL;
    crew->count = 0;
}
