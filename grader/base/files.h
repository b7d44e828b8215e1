// Whole files and folders.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { FILES_PATH = 4096 };

// The text of a regular file of at most `limit` bytes, freed by the caller; NULL with a message.
char *files_read(const char *path, size_t limit);

// The same for a file that may hold any bytes: `size` of them, with a 0 behind.
char *files_read_bytes(const char *path, size_t limit, size_t *size);

// The same for a file of text that was handed in (see text_check): `name` must be a regular file in `folder`
// itself, not reached by a link or a mount, and without another name (a hard link). The folder may not be a
// link either.
char *files_read_untrusted(const char *folder, const char *name, size_t limit);

// Is it a folder, and not a link to one?
bool files_is_folder(const char *path);

// The same for one that can be opened, too. False with a message.
bool files_check_folder(const char *path);

// Copies such a file, which may hold any bytes, to `path`, which must not exist. False with a message.
bool files_take(const char *folder, const char *name, const char *path, size_t limit);

// Replaces the file. False with a message.
bool files_write(const char *path, const char *text);

// Replaces the file unless it already holds just these bytes; `changed` tells. False with a message.
bool files_write_changed(const char *path, const void *bytes, size_t size, bool *changed);

// Writes a file that is there whole or not at all, whatever happens meanwhile. A file that is there is
// replaced, or left as it is when not `replace`. False with a message.
bool files_write_whole(const char *path, const char *text, bool replace);

// Makes what was made or renamed in a folder outlive a loss of power. False when it cannot.
bool files_sync_folder(const char *folder);

// How the names of files begin that files_write_whole has not finished.
#define FILES_NEW ".new-"

// Removes those of them that a killed process left in the folder.
void files_forget_new(const char *folder);
bool files_exists(const char *path);

// A new private folder under the system's temporary folder; its path is absolute and without links.
bool files_make_temporary(char path[FILES_PATH]);

// Makes a folder and its parents.
bool files_make_folder(const char *path);

// Removes all that a folder holds, which was made here.
void files_empty(const char *path);

// Removes such a folder, with all it holds.
void files_remove(const char *path);

// The folder that a path's file lies in, "./" where the path names none; ends with a slash.
void files_folder_of(char folder[FILES_PATH], const char *path);

// Writes "a/b" to path, which may not be a; aborts when it does not fit.
void files_join(char path[FILES_PATH], const char *a, const char *b);

// Calls visit for each entry of a folder in the order of names, without "." and "..". False when it cannot be
// read.
bool files_list(const char *folder, void (*visit)(const char *name, void *context), void *context);
