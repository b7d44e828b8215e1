// What the grader says to a nursery (worker/nursery.h), over a socket that keeps messages apart: with each
// order it sends the child's descriptors 0, 1 (and 2) and 3. The nursery answers each, and once, unasked,
// that it is ready.
#pragma once

#include "protocol/protocol.h"

#include <stdint.h>

enum { NURSERY_SOCKET = 0, NURSERY_DESCRIPTORS = 3, NURSERY_ARGUMENTS = 10 };

typedef struct NurseryOrder {
    char folder[PROTOCOL_PATH]; // of the lab; absolute, and all of it that the child sees beside the system
    uint32_t cpu_seconds, memory_mib, file_mib; // limits, see ProcessLimits
    int32_t argument_count;                     // 0: the child is a worker; else it becomes that program
    char arguments[NURSERY_ARGUMENTS][PROTOCOL_PATH];
} NurseryOrder;

typedef struct NurseryAnswer {
    int32_t pid; // of the child, which is one of the grader's; 0: it is ready; below 0: it cannot
} NurseryAnswer;
