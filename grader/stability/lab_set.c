#include "stability/lab_set.h"

#include "scene/check.h"

#include <string.h>

static LabArtist *open_artist(LabSet *labs, const char *lab) {
    for (int i = 0; i < labs->count; i++)
        if (strcmp(labs->artists[i].rubric.id, lab) == 0)
            return &labs->artists[i];
    INVARIANT(labs->count < BENCH_LABS);
    LabArtist *artist = &labs->artists[labs->count];
    if (lab_artist_open(artist, lab)) {
        artist->without = labs->without;
        return &labs->artists[labs->count++];
    }
    lab_artist_close(artist);
    return NULL;
}

// Appends the edits of `more`; false when there is no room.
static bool append(Change *both, const Change *more) {
    if (both->edit_count + more->edit_count > CHANGE_MAX_EDITS)
        return false;
    for (int i = 0; i < more->edit_count; i++)
        both->edits[both->edit_count++] = more->edits[i];
    return true;
}

// The change after the fault, tried when it is first asked for.
static const Faulted *find_faulted(LabSet *labs, LabArtist *artist, const Change *fault,
                                   const Change *change) {
    for (int i = 0; i < labs->faulted_count; i++)
        if (labs->faulted[i].change == change)
            return &labs->faulted[i];
    INVARIANT(labs->faulted_count < BENCH_FAULTED);
    Faulted *faulted = &labs->faulted[labs->faulted_count++];
    *faulted = (Faulted){.change = change, .both = {.name = change->name}};
    faulted->fits = append(&faulted->both, fault) && append(&faulted->both, change) &&
                    lab_artist_change(artist, &faulted->both);
    check_clear();
    return faulted;
}

// Makes `change` what is drawn where it is asked for. False with a message when the lab has no such mistake.
static bool add_fault(LabSet *labs, LabArtist *artist, const Change **change) {
    const Change *fault = rubric_mistake(&artist->rubric, labs->fault);
    if (fault && *change) {
        const Faulted *faulted = find_faulted(labs, artist, fault, *change);
        *change = faulted->fits ? &faulted->both : *change;
    } else {
        *change = fault;
    }
    return fault != NULL;
}

LabArtist *lab_set_artist(LabSet *labs, const char *lab, const Change *change) {
    LabArtist *artist = open_artist(labs, lab);
    if (artist && labs->fault && strcmp(labs->fault_lab, lab) == 0 && !add_fault(labs, artist, &change))
        return NULL;
    return artist && lab_artist_change(artist, change) ? artist : NULL;
}

int lab_set_most_objects(LabSet *labs) {
    int most = 0;
    for (int i = 0; i < labs->count; i++) {
        if (labs->artists[i].most_objects > most)
            most = labs->artists[i].most_objects;
        labs->artists[i].most_objects = 0;
    }
    return most;
}

void lab_set_close(LabSet *labs) {
    for (int i = 0; i < labs->count; i++)
        lab_artist_close(&labs->artists[i]);
    *labs = (LabSet){0};
}
