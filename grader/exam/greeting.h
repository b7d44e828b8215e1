// What a worker says first.
#pragma once

#include "base/process.h"
#include "protocol/protocol.h"

#include <stdbool.h>

// Takes the worker's first Reply; true when it is ready to draw. Of another build only the first four bytes
// are read, since its records may have other sizes, and each side would wait for the other: it is killed, and
// reply->message says so. Where the worker ends before it spoke, or says why it cannot draw, false, too.
bool greeting_hear(Process *process, Reply *reply);
