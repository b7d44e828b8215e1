#include "stability/lab_set.h"

#include "scene/check.h"

#include <string.h>

static LabArtist *open_artist(LabSet *labs, const char *lab) {
    for (int i = 0; i < labs->count; i++)
        if (strcmp(labs->artists[i].rubric.id, lab) == 0)
            return &labs->artists[i];
    INVARIANT(labs->count < BENCH_LABS);
    LabArtist *artist = &labs->artists[labs->count];
    if (lab_artist_open(artist, lab))
        return &labs->artists[labs->count++];
    lab_artist_close(artist);
    return NULL;
}

LabArtist *lab_set_artist(LabSet *labs, const char *lab, const Change *change) {
    LabArtist *artist = open_artist(labs, lab);
    if (artist && !change && labs->fault && strcmp(labs->fault_lab, lab) == 0) {
        change = rubric_mistake(&artist->rubric, labs->fault);
        if (!change)
            return NULL;
    }
    return artist && lab_artist_change(artist, change) ? artist : NULL;
}

void lab_set_close(LabSet *labs) {
    for (int i = 0; i < labs->count; i++)
        lab_artist_close(&labs->artists[i]);
    *labs = (LabSet){0};
}
