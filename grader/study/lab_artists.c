#include "study/lab_artists.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/hash.h"

#include <stdlib.h>
#include <string.h>

static bool open_artist(Artist *artist, const Crew *crew, const Method *method) {
    if (method->submission)
        return artist_open_submission(artist, method->lab, crew->submission, crew->jail) &&
               (!method->change || artist_adapt(artist, method->change));
    return artist_open(artist, method->lab) && artist_change(artist, method->change);
}

static Artist *hire(const Crew *crew, const Method *method) {
    Artist *artist = calloc(1, sizeof *artist);
    INVARIANT(artist);
    if (open_artist(artist, crew, method))
        return artist;
    artist_close(artist);
    free(artist);
    return NULL;
}

Artist *crew_get(Crew *crew, const Method *method) {
    for (int i = 0; i < crew->count; i++)
        if (crew->members[i].submission == method->submission && crew->members[i].change == method->change &&
            strcmp(crew->members[i].lab, method->lab) == 0)
            return crew->members[i].artist;
    INVARIANT(crew->count < CREW_MOST);
    Artist *artist = hire(crew, method);
    if (!artist)
        return NULL;
    crew->members[crew->count].artist = artist;
    crew->members[crew->count].lab = method->lab;
    crew->members[crew->count].change = method->change;
    crew->members[crew->count++].submission = method->submission;
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

void crew_dismiss(Crew *crew) {
    for (int i = 0; i < crew->count; i++) {
        artist_close(crew->members[i].artist);
        free(crew->members[i].artist);
    }
    crew->count = 0;
}
