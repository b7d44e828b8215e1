// Seeds of exams: any, or where there are no solutions, those that are recorded (exam_file.h) and listed in
// ROOT/grader/recorded/seeds.json.
#pragma once

#include <stdbool.h>
#include <stdint.h>

// A seed that nobody can foresee; where there are no solutions, one of those recorded. False with a message.
bool exam_seeds_draw(uint64_t *seed);

// Writes at most `most` of the seeds that are recorded, in their order, and returns their number; 0 with a
// message when the list cannot be read.
int exam_seeds_list(uint64_t *list, int most);
