// Who draws a lab's frames for the study: the solution, the solution with a change, or a submission.
#pragma once

#include "exam/painters.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct LabArtist {
    Rubric rubric;          // of the lab
    Painters roster;        // ours: the worker and what it draws with
    const Painter *painter; // ours: whom lab_artist_draw asks; NULL for a submission
    WorkerClient client;    // a submission's worker
    WorkerClient counter;   // whose frames are counted: counted_frame.h
    Description table;      // ours: of the lab, once lab_artist_pass_kinds asked for it
    char renderer[128];     // as the last frame's Reply has it
    uint32_t without;       // objects that are left out of all scenes, a bit each
    int most_objects;       // of a scene that it drew
} LabArtist;

// The solution of lab `id` ("05"), for frames that are few and small. False with a message.
bool lab_artist_open(LabArtist *artist, const char *id);

// The same for frames whose times count: under the conditions of a submission that is measured (shaders as
// good as the driver makes them; by EGL the machine's GPU).
bool lab_artist_open_measured(LabArtist *artist, const char *id, ContextKind context);

// A submission's lab `id`; `submission` is a folder shaped like labs/ or the lab's own. It is compiled and
// drawn in the jail, which outlives the artist (NULL: outside). False with a message (gcc's first words where
// it does not compile).
bool lab_artist_open_submission(LabArtist *artist, const char *id, const char *submission, const Jail *jail,
                                ContextKind context);

// Applies the change's edits to a submission's shaders as far as their texts stand there. Before it first
// draws. False with a message when a file cannot be written.
bool lab_artist_adapt(LabArtist *artist, const Change *change);

// From now on the solution is drawn with this change; NULL: as it is. Ours only. `change` must outlive the
// artist. False with a message when an edit does not apply or the result does not compile.
bool lab_artist_change(LabArtist *artist, const Change *change);

// Leaves the artist's objects out of a scene that has them: each shrinks to a point where it stands, so that
// the numbers of the others stay.
void lab_artist_leave_out(LabArtist *artist, Scene *scene);

// Draws; true when the picture is there. False with a message when the lab or its process failed.
bool lab_artist_draw(LabArtist *artist, const Request *asked, Image *image, Reply *reply);

// What each pass of the solution is for (PassKind), LAB_MAX_PASSES of them. Ours only. NULL with a message
// when the worker does not say.
const int32_t *lab_artist_pass_kinds(LabArtist *artist);

void lab_artist_close(LabArtist *artist); // accepts a zeroed artist
