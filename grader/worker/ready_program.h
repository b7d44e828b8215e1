// The program with which most labs draw their map, compiled before there is a lab: it takes the driver longer
// than all else of a small frame.
#pragma once

#include "program.h"

// Makes it, and draws with it once as a map is drawn; its uniforms are as new then. False with a message.
bool ready_program_create(void);

// Does the lab ask for just this program, by files of just this text (see shader_source_folders)? Then it
// gets it, once, in the place of program_create's; else false.
bool ready_program_take(Program *program, const ProgramFiles *files);
