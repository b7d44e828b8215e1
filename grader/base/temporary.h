// The temporary folders that are there, for the case that a signal ends the program.
#pragma once

// Notes a folder that was made, or that one was removed. files.h does both. While folders are noted, a signal
// by which a user ends the program (SIGINT, SIGTERM, SIGHUP) also removes them, a moment after its death; a
// program that has a handler of its own for the signal, or ignores it (nohup), keeps it. A child that was
// forked removes only what it has noted itself.
void temporary_add(const char *folder);
void temporary_drop(const char *folder);
