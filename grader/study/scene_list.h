// What the study holds, for scripts.
#pragma once

#include <stdio.h>

// A line a scene: its name, how many objects it has, its chart's title, and its labs' families, "linear
// (05)", with "; " between them; tabs between the four.
void scene_list_write(FILE *file);
