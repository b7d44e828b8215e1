#include "base/pipe.h"

#include <errno.h>
#include <unistd.h>

bool pipe_read(int descriptor, void *data, size_t size) {
    for (size_t done = 0; done < size;) {
        ssize_t n = read(descriptor, (char *)data + done, size - done);
        if (n <= 0 && !(n < 0 && errno == EINTR))
            return false;
        done += n > 0 ? (size_t)n : 0;
    }
    return true;
}

bool pipe_write(int descriptor, const void *data, size_t size) {
    for (size_t done = 0; done < size;) {
        ssize_t n = write(descriptor, (const char *)data + done, size - done);
        if (n <= 0 && !(n < 0 && errno == EINTR))
            return false;
        done += n > 0 ? (size_t)n : 0;
    }
    return true;
}
