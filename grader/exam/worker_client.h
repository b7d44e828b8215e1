// Our end of a worker process: one lab, asked for frames.
//
// Interface: fill in folder, trust, jail, context and seconds; worker_client_draw asks for one frame,
// worker_client_describe for the lab's table; both start the process when it does not run. A lost worker
// stays lost until worker_client_restart. worker_client_stop ends it. One thread at a time.
#pragma once

#include "exam/known_place.h"
#include "scene/context_kind.h"
#include "base/files.h"
#include "scene/image.h"
#include "jail/jail.h"
#include "base/process.h"
#include "protocol/protocol.h"

#include <stdbool.h>

typedef enum Trust {
    TRUST_OURS,  // a solution: no limits, compiled shaders are kept between runs
    TRUST_NOBODY // a submission: limits on time and memory, nothing shared, and the jail
} Trust;

typedef struct WorkerClient {
    char folder[FILES_PATH]; // holds lab.so and the lab's shaders; "-" for a worker of several labs of ours
    Trust trust;
    const Jail *jail; // for a submission; NULL: its own author grades it, outside
    ContextKind context;
    const char *program; // beside ours, that speaks protocol.h; NULL: the worker
    bool quick_shaders;  // compiled sooner and worse: for frames that are few and small; the same pixels
    bool hardware;       // by EGL the machine's GPU may draw, chosen by EGL's own variables; ours only
    double seconds;      // processor time that a submission may use
    double patience;     // wall time that it may use, in units of that; 0: 1
    bool each_turn; // `seconds` is wall time and starts again with worker_client_begin, whoever draws: for a
                    // window
    bool muted;     // what the lab says does not come into replies: see grade/hidden.h
    bool hushed;    // ... and it has said something, or was lost
    bool address;   // lab.so is compiled with AddressSanitizer, which says on standard error what it finds
    bool started;
    bool greeted;        // it has said that it is ready
    bool fault;          // the machine or we are to blame: no worker could be started. Until it is stopped
    bool has_crash;      // by SEGV, ABRT or BUS
    Request crash;       // the first for which it did
    KnownPlace place;    // the last that it told
    int restarts;        // by worker_client_restart
    double used_seconds; // processor time of the workers before this one
    Process process;
} WorkerClient;

typedef enum DrawResult {
    DRAW_OK,      // the picture is there
    DRAW_FAILED,  // the lab said why not: reply->message
    DRAW_LOST,    // the process is gone: reply->message says how
    DRAW_TIMEOUT, // the same, because it used up its time
    DRAW_FAULT    // no worker was there to draw it, before anything of the lab ran: reply->message says why
} DrawResult;

// Draws one frame; starts the worker first when it does not run. A lost worker stays lost. `image` is created
// at the size of the request when it has another one. A worker of several labs looks at request->folder.
DrawResult worker_client_draw(WorkerClient *client, const Request *request, Image *image, Reply *reply);

// The lab's table, made safe (see Description); all zero unless the result is DRAW_OK.
DrawResult worker_client_describe(WorkerClient *client, const Request *request, Description *description,
                                  Reply *reply);

// Starts the worker without waiting for it, so that several start side by side. False: no process can be
// started.
bool worker_client_start(WorkerClient *client);
// The wall time of a running worker starts again: what has passed was spent by us, or on earlier turns.
void worker_client_begin(WorkerClient *client);

// Starts another worker in the place of one that was lost, for what is left of its time. False when no time
// is left, or after too many of them.
bool worker_client_restart(WorkerClient *client);

void worker_client_stop(WorkerClient *client); // accepts a zeroed client
