// What draws for a feed: a worker process with its folder, of mine, of the reference or of the truth.
#pragma once

#include "exam/worker_client.h"
#include "compile/compiler.h"
#include "compile/rubric.h"

#include <stdbool.h>

typedef enum FeedKind { FEED_MINE, FEED_REFERENCE, FEED_TRUTH, FEED_COUNT } FeedKind;

typedef struct DrawerSetup {
    FeedKind kind;
    const Rubric *rubric;   // its files are taken
    const char *submission; // FEED_MINE: the lab's folder
    ContextKind context;
    double seconds; // that a frame of mine may take
} DrawerSetup;

typedef struct Drawer {
    WorkerClient client;
    Description table; // of its lab
    bool removes;      // its folder, in the end
} Drawer;

// Is there a program that draws the truth?
bool drawer_has_truth(void);

// Builds what it draws with, in a folder of its own. `earlier` may lend its lab.so. Then starts the worker.
// False with a message; `log` gets gcc's words.
bool drawer_start(Drawer *drawer, const DrawerSetup *setup, const Drawer *earlier, char log[COMPILE_LOG]);

// Fills the table.
DrawResult drawer_describe(Drawer *drawer, Reply *reply);

// Draws, with those knobs of the request that its lab knows: the tables of mine and of the reference may
// differ. What the lab prints is passed on to standard output.
DrawResult drawer_draw(Drawer *drawer, const Request *request, Image *image, Reply *reply);

// Ends the worker and removes its folder. Accepts a zeroed drawer.
void drawer_stop(Drawer *drawer);
