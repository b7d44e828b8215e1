// Remarks without points about a lab that is passed: what each frame says of itself (common/remark.h).
#pragma once

#include "diagnose/result.h"

#define REMARK "without points: " // how each line begins

enum { REMARKS_MAX = 8 };

// Zeroed: no frame yet.
typedef struct Remarks {
    char lines[REMARKS_MAX][200];
    int frames[REMARKS_MAX]; // of all, in which it was said
    int all;
} Remarks;

// Takes what one frame says: lines, untrusted.
void remarks_take(Remarks *remarks, const char *text);

// Writes those that every frame said, each as a line "without points: ...", into `text`; "" when there are
// none.
void remarks_write(const Remarks *remarks, char *text, size_t size);
