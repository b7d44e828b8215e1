#include "study/lab_artists.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/hash.h"

#include <stdlib.h>
#include <string.h>

static bool open_artist(LabArtist *artist, const LabArtists *artists, const Method *method) {
    if (method->submission)
        return lab_artist_open_submission(artist, method->lab, artists->submission, artists->jail,
                                          artists->context) &&
               (!method->change || lab_artist_adapt(artist, method->change));
    return lab_artist_open_measured(artist, method->lab, artists->context) &&
           lab_artist_change(artist, method->change);
}

static LabArtist *hire(const LabArtists *artists, const Method *method) {
    LabArtist *artist = calloc(1, sizeof *artist);
    INVARIANT(artist);
    if (open_artist(artist, artists, method)) {
        artist->without = artists->without;
        return artist;
    }
    lab_artist_close(artist);
    free(artist);
    return NULL;
}

LabArtist *lab_artists_get(LabArtists *artists, const Method *method) {
    for (int i = 0; i < artists->count; i++)
        if (artists->members[i].submission == method->submission &&
            artists->members[i].change == method->change && strcmp(artists->members[i].lab, method->lab) == 0)
            return artists->members[i].artist;
    INVARIANT(artists->count < CREW_MOST);
    LabArtist *artist = hire(artists, method);
    if (!artist)
        return NULL;
    artists->members[artists->count].artist = artist;
    artists->members[artists->count].lab = method->lab;
    artists->members[artists->count].change = method->change;
    artists->members[artists->count++].submission = method->submission;
    return artist;
}

uint64_t lab_artists_key(const LabArtist *artist) {
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

void lab_artists_dismiss(LabArtists *artists) {
    for (int i = 0; i < artists->count; i++) {
        lab_artist_close(artists->members[i].artist);
        free(artists->members[i].artist);
    }
    artists->count = 0;
}
