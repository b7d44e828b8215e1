// When something was handed in, as learning systems write it.
#pragma once

#include <stdbool.h>
#include <time.h>

// "2026-11-03 09:30:00 -0800", "2026-11-03T09:30", "2026-11-03-09-30-00", "3.11.2026 09:30",
// "Tuesday, 3 November 2026, 9:30 AM", "Nov 3, 2026 930 AM". Without a zone it is this machine's. False,
// without a message, when it is none of them.
bool hand_in_time_parse(time_t *time, const char *text);
