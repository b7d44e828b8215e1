// Errors. What a user can cause is `false` plus one message; a broken invariant of ours aborts.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// Keeps the thread's first message since check_clear (later ones are mostly its consequences). Always returns
// false, so that a caller writes `return check_fail(...)`. The message should name file, line and remedy.
bool check_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));

// The message kept, "" when there is none. Valid until the next call of this module.
const char *check_message(void);

// Forgets the message.
void check_clear(void);

// Prints the place and aborts: for what only a fault in Shadow Lab itself can cause.
_Noreturn void check_abort(const char *file, int line, const char *condition);

#define INVARIANT(condition) ((condition) ? (void)0 : check_abort(__FILE__, __LINE__, #condition))

// snprintf that appends at the end of the string in `text` of `size` bytes; cuts what does not fit.
void check_append(char *text, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
