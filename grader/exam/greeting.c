#include "exam/greeting.h"

#include <stdio.h>

bool greeting_hear(Process *process, Reply *reply) {
    const size_t first = sizeof reply->magic;
    if (!process_exchange(process, NULL, 0, reply, first))
        return false;
    if (reply->magic != PROTOCOL_READY && reply->magic != PROTOCOL_CRASHED) {
        process_stop(process);
        snprintf(reply->message, sizeof reply->message,
                 "the worker is of another build than this program: run make, and start it again");
        return false;
    }
    return process_exchange(process, NULL, 0, (char *)reply + first, sizeof *reply - first) &&
           reply->magic == PROTOCOL_READY && reply->drawn;
}
