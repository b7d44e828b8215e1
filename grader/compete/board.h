// The standings for people and for Gradescope.
#pragma once

#include "compete/arena.h"
#include "compete/standing.h"

#include <stdio.h>

// A line a hand-in, those that are not ranked below the line.
void board_print(const Standing *standings, int count, const Arena *arena, FILE *out);

// The same as a page that needs no other file; freed by the caller. NULL with a message.
char *board_page(const Standing *standings, int count, const Arena *arena);

// Adds the key "leaderboard" to a results.json that build/grade has written for Gradescope; where the hand-in
// is not ranked, the reason to its output. False with a message.
bool board_add_to_results(const Standing *standing, const char *path);
