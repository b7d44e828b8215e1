// Walks through the folder, then through what the archives in it hold, and notes each folder that may be a
// lab's.
#include "intake/submission.h"

#include "scene/check.h"
#include "base/places.h"
#include "base/blame.h"
#include "base/find_file.h"
#include "intake/archive.h"
#include "intake/lab_name.h"
#include "scene/count.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { MAX_ENTRIES = 20000, MAX_SOURCE = 1 << 18, ROOM = 300 }; // ROOM: for one more name in a path
enum { RANK_TITLE = 100, RANK_NAME = 200, RANK_OUTER = 300, RANK_EMPTY = 1000, RANK_ARCHIVE = 2000 };

typedef struct FolderWalk {
    Submission *submission;
    const char *folder;
    char above[3]; // the lab that the nearest name above tells, "" for none
    int depth, rank;
    bool stopped; // a folder inside could not be read for a reason of ours
} FolderWalk;

static void look_into(FolderWalk *outer, const char *folder, const char *above, int depth);

static bool is_our_name(const char *name, const char *id) {
    char ours[FILES_PATH];
    return places_find_lab(ours, id) && strcmp(strrchr(ours, '/') + 1, name) == 0;
}

static void add_lab(FolderWalk *walk, const char *folder, const char *id, int rank) {
    Submission *submission = walk->submission;
    if (submission->lab_count == SUBMISSION_MAX_LABS)
        return;
    FoundLab *lab = &submission->labs[submission->lab_count++];
    *lab = (FoundLab){.folder = strdup(folder), .rank = rank + walk->rank + walk->depth};
    submission->single = submission->single || walk->depth == 0;
    INVARIANT(lab->folder);
    memcpy(lab->id, id, sizeof lab->id);
}

// Courses number their sheets as they like: what its lab.c says it is comes before a name that is not ours.
static bool find_title(char id[3], const char *folder, const char *file) {
    char *text = files_read_untrusted(folder, file, MAX_SOURCE);
    const bool found = text && lab_name_of_text(id, text);
    free(text);
    check_clear();
    return found;
}

// Notes the folder if it may be a lab's. `above`: the lab that its own name or one above tells.
static void judge_folder(FolderWalk *walk, const char *folder, const char *name, const char *above) {
    char file[FIND_FILE_NAME], id[3] = "";
    check_clear();
    const bool filled = find_file(file, folder, "lab.c");
    walk->stopped = walk->stopped || (check_message()[0] && blame_is_ours(errno));
    if (above[0] && is_our_name(name, above))
        add_lab(walk, folder, above, filled ? 0 : RANK_EMPTY);
    else if (filled && find_title(id, folder, file))
        add_lab(walk, folder, id, RANK_TITLE);
    else if (filled && walk->depth == 0 && lab_name_find(id, name))
        add_lab(walk, folder, id, RANK_OUTER);
    else if (filled)
        add_lab(walk, folder, above, above[0] ? RANK_NAME : RANK_OUTER);
}

// The name of the outermost folder is mostly that of who hands in.
static void enter(FolderWalk *walk, const char *folder, const char *name, const char *above) {
    char id[3];
    const bool told = lab_name_find(id, name) && (walk->depth > 0 || is_our_name(name, id));
    judge_folder(walk, folder, name, told ? id : above);
    if (walk->depth < SUBMISSION_MAX_DEPTH)
        look_into(walk, folder, told ? id : above, walk->depth + 1);
    else
        snprintf(walk->submission->note, sizeof walk->submission->note,
                 "more than %d folders deep nothing was looked for", SUBMISSION_MAX_DEPTH);
}

static void keep_archive(Submission *submission, const char *path) {
    if (submission->archive_count == SUBMISSION_MAX_ARCHIVES) {
        snprintf(submission->note, sizeof submission->note, "only the first %d archives inside were opened",
                 SUBMISSION_MAX_ARCHIVES);
        return;
    }
    submission->archives[submission->archive_count++] = strdup(path);
}

static void look(const char *name, void *context) {
    FolderWalk *walk = context;
    Submission *submission = walk->submission;
    char path[FILES_PATH];
    struct stat info;
    if (extract_passes_folder(name, strlen(name)) || strlen(walk->folder) + strlen(name) + ROOM > FILES_PATH)
        return;
    if (++submission->entries > MAX_ENTRIES) {
        snprintf(submission->note, sizeof submission->note,
                 "it holds more than %d files: the rest was not looked at", MAX_ENTRIES);
        return;
    }
    files_join(path, walk->folder, name);
    if (lstat(path, &info) != 0) {
        walk->stopped = walk->stopped ||
                        (blame_is_ours(errno) && !check_fail("%s cannot be read: %s", path, strerror(errno)));
        return;
    }
    if (S_ISDIR(info.st_mode))
        enter(walk, path, name, walk->above);
    else if (S_ISREG(info.st_mode) && archive_is_name(name))
        keep_archive(submission, path);
}

static void look_into(FolderWalk *outer, const char *folder, const char *above, int depth) {
    FolderWalk walk = *outer;
    walk.folder = folder;
    walk.depth = depth;
    snprintf(walk.above, sizeof walk.above, "%s", above);
    if (!files_list(folder, look, &walk))
        walk.stopped = walk.stopped || blame_is_ours(errno);
    outer->stopped = outer->stopped || walk.stopped;
    if (!outer->stopped)
        check_clear();
}

static bool walk_through(Submission *submission, const char *folder, int rank) {
    char resolved[FILES_PATH];
    FolderWalk walk = {.submission = submission, .rank = rank};
    if (!realpath(folder, resolved) || strlen(resolved) + ROOM > FILES_PATH)
        return check_fail("the path of %s is too long", folder);
    enter(&walk, resolved, strrchr(resolved, '/') + 1, "");
    return !walk.stopped;
}

// Opens archive number i into a folder of its own below `unpacked`, and looks through it.
static Extracted open_archive(Submission *submission, const Jail *jail, const char *archive, int i,
                              int rank) {
    char folder[FILES_PATH], number[16];
    if (!submission->unpacked[0] && !files_make_temporary(submission->unpacked))
        return EXTRACT_FAULT;
    snprintf(number, sizeof number, "archive%d/", i);
    files_join(folder, submission->unpacked, number);
    if (!files_make_folder(folder))
        return EXTRACT_FAULT;
    const Extracted result = archive_unpack(jail, archive, folder);
    if (result != EXTRACT_OK)
        return result;
    return walk_through(submission, folder, rank) ? EXTRACT_OK : EXTRACT_FAULT;
}

static void note_bad_archive(Submission *submission, const char *path) {
    if (!submission->why[0])
        snprintf(submission->why, sizeof submission->why, "%.100s: %.280s", strrchr(path, '/') + 1,
                 check_message());
    check_clear();
}

// Archives inside: those in them, too, as they are found. A bad one is only noted.
static Extracted open_inner(Submission *submission, const Jail *jail) {
    for (int i = 0; i < submission->archive_count; i++) {
        const Extracted result = open_archive(submission, jail, submission->archives[i], i + 1, RANK_ARCHIVE);
        if (result == EXTRACT_FAULT)
            return result;
        if (result == EXTRACT_BAD_ARCHIVE)
            note_bad_archive(submission, submission->archives[i]);
    }
    return EXTRACT_OK;
}

Extracted submission_open(Submission *submission, const Jail *jail, const char *path) {
    struct stat info;
    memset(submission, 0, sizeof *submission);
    snprintf(submission->folder, sizeof submission->folder, "%s", path);
    Extracted result = EXTRACT_FAULT;
    if (stat(path, &info) != 0)
        check_fail("%s cannot be read", path);
    else if (S_ISREG(info.st_mode))
        result = open_archive(submission, jail, path, 0, 0);
    else if (walk_through(submission, path, 0))
        result = EXTRACT_OK;
    if (result == EXTRACT_OK)
        result = open_inner(submission, jail);
    if (result == EXTRACT_OK && submission->lab_count == 0 && submission->why[0])
        check_fail("%s", submission->why);
    return result == EXTRACT_OK && submission->lab_count == 0 && submission->why[0] ? EXTRACT_BAD_ARCHIVE
                                                                                    : result;
}

void submission_close(Submission *submission) {
    for (int i = 0; i < submission->lab_count; i++)
        free(submission->labs[i].folder);
    for (int i = 0; i < submission->archive_count; i++)
        free(submission->archives[i]);
    if (submission->unpacked[0])
        files_remove(submission->unpacked);
    memset(submission, 0, sizeof *submission);
}

const char *submission_shown(const Submission *submission, const char *folder) {
    const char *top =
        submission->unpacked[0] && strncmp(folder, submission->unpacked, strlen(submission->unpacked)) == 0
            ? submission->unpacked
            : submission->folder;
    const size_t length = strlen(top);
    return strncmp(folder, top, length) == 0 && folder[length] == '/' ? folder + length + 1
                                                                      : strrchr(folder, '/') + 1;
}

const char *submission_find(const Submission *submission, const char *id, char *note, size_t size) {
    const FoundLab *best = NULL, *other = NULL;
    note[0] = '\0';
    for (int i = 0; i < submission->lab_count; i++) {
        const FoundLab *lab = &submission->labs[i];
        if (strcmp(lab->id, id) != 0)
            continue;
        if (!best || lab->rank < best->rank) {
            other = best;
            best = lab;
        } else {
            other = lab;
        }
    }
    if (best && other && other->rank < RANK_EMPTY)
        snprintf(note, size, "lab %s is there twice: %.150s is graded, not %.150s", id,
                 submission_shown(submission, best->folder), submission_shown(submission, other->folder));
    return best ? best->folder : NULL;
}

const char *submission_nameless(const Submission *submission) {
    const char *found = NULL;
    for (int i = 0; i < submission->lab_count; i++) {
        if (submission->labs[i].rank % RANK_ARCHIVE < RANK_OUTER)
            continue;
        if (found)
            return NULL;
        found = submission->labs[i].folder;
    }
    return found;
}

const char *submission_find_of(const Submission *submission, const char *id, int asked, char *note,
                               size_t size) {
    const char *found = submission_find(submission, id, note, size);
    return found || asked > 1 ? found : submission_nameless(submission);
}
