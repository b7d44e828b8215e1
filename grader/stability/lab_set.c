#include "stability/lab_set.h"

#include "scene/check.h"

#include <string.h>

static Artist *open_artist(Bench *bench, const char *lab) {
    for (int i = 0; i < bench->count; i++)
        if (strcmp(bench->artists[i].rubric.id, lab) == 0)
            return &bench->artists[i];
    INVARIANT(bench->count < BENCH_LABS);
    Artist *artist = &bench->artists[bench->count];
    if (artist_open(artist, lab))
        return &bench->artists[bench->count++];
    artist_close(artist);
    return NULL;
}

Artist *bench_artist(Bench *bench, const char *lab, const Change *change) {
    Artist *artist = open_artist(bench, lab);
    if (artist && !change && bench->fault && strcmp(bench->fault_lab, lab) == 0) {
        change = rubric_mistake(&artist->rubric, bench->fault);
        if (!change)
            return NULL;
    }
    return artist && artist_change(artist, change) ? artist : NULL;
}

void bench_close(Bench *bench) {
    for (int i = 0; i < bench->count; i++)
        artist_close(&bench->artists[i]);
    *bench = (Bench){0};
}
