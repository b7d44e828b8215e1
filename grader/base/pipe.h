// Whole blocks of bytes over a pipe.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// Reads or writes exactly `size` bytes, waiting for them. False when the other end is closed.
bool pipe_read(int descriptor, void *data, size_t size);
bool pipe_write(int descriptor, const void *data, size_t size);
