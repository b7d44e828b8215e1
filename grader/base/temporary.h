// The temporary folders that are there, for the case that a signal ends the program.
#pragma once

// Notes a folder that was made, or that one was removed. files.h does both.
void temporary_add(const char *folder);
void temporary_drop(const char *folder);

// From now on a signal by which a user ends the program (SIGINT, SIGTERM, SIGHUP) also removes the noted
// folders, a moment after its death.
void temporary_on_signals(void);
