// One drawer of the window: a thread with a worker of its own, so that the window never waits for it,
// whatever the student's code does. It draws the newest request only. When its files change it builds them
// aside, and changes over once the new worker has drawn; until then, and when it cannot, the last good one
// goes on.
#pragma once

#include "window/drawer.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct FeedSetup {
    DrawerSetup drawer;
    bool waits;         // it builds once feed_renew is called, not at once
    void (*wake)(void); // called from the thread when there is news
} FeedSetup;

// What is known of a feed at one moment.
typedef struct FeedNews {
    uint64_t changes;   // so far: grows when anything here may have changed
    uint64_t answered;  // number of the last request that was drawn or failed
    uint64_t pictures;  // number of pictures so far
    uint64_t described; // number of descriptions so far
    double busy_since;  // of process_now; 0: idle
    bool building;      // busy with gcc
    bool dead;          // no worker runs: only new files help
    bool outdated;      // the picture is that of older files
    char problem[PROTOCOL_TEXT], warning[PROTOCOL_TEXT]; // "": none
    Description description;
    float milliseconds[LAB_MAX_PASSES]; // of the last picture
    FrameFacts facts;                   // the same
    double turn;                        // seconds from request to picture
} FeedNews;

typedef struct Feed {
    FeedSetup setup;
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t work;
    bool running;
    // Under the lock.
    Request request;
    uint64_t asked; // number of `request`, 0: none yet
    bool renew, quit;
    int again; // frames to draw once more: the first ones of a worker pay for its shaders
    Image picture;
    FeedNews news;
    int drawing; // of `drawers`: is being waited for, and may be cancelled; -1: none
    // The thread's own.
    Drawer drawers[2]; // one draws, the other one tries new files
    int current;       // of `drawers`
    Image canvas;
} Feed;

// Begins to build what the feed draws with. False with a message.
bool feed_start(Feed *feed, const FeedSetup *setup);
void feed_stop(Feed *feed); // accepts a zeroed feed

// Asks for a frame, instead of the one that waits. `number` grows.
void feed_ask(Feed *feed, const Request *request, uint64_t number);

// The files have changed: they are built, once what is being drawn is done or has taken too long.
void feed_renew(Feed *feed);

// Copies the news. To be called often: it also gives up what takes too long when new files wait.
void feed_look(Feed *feed, FeedNews *news);

// Copies the last picture. False when there is none.
bool feed_take(Feed *feed, Image *picture);
