#include "feed.h"

#include "check.h"
#include "derive.h"
#include "home.h"
#include "score.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

enum { WARM_UP = 3 }; // frames until the times are true

static const double OURS_SECONDS = 60; // that a frame of ours may take
static const double PATIENCE = 0.5;    // seconds, with what is being drawn when new files are there

// What the thread does next.
typedef struct Turn {
    Request request;
    uint64_t number; // 0: nothing to draw yet
    bool renew;
    double start;
} Turn;

static bool has_work(const Feed *feed) {
    return feed->renew || (!feed->news.dead && (feed->again > 0 || feed->asked > feed->news.answered));
}

// Waits for work. False when the feed ends.
static bool next_turn(Feed *feed, Turn *turn) {
    pthread_mutex_lock(&feed->lock);
    while (!feed->quit && !has_work(feed))
        pthread_cond_wait(&feed->work, &feed->lock);
    turn->request = feed->request;
    turn->number = feed->asked;
    turn->renew = feed->renew;
    turn->start = process_now();
    feed->renew = false;
    feed->news.busy_since = turn->start;
    feed->news.building = turn->renew;
    if (turn->renew)
        feed->news.problem[0] = '\0';
    bool goes_on = !feed->quit;
    pthread_mutex_unlock(&feed->lock);
    return goes_on;
}

static void publish(Feed *feed, const Turn *turn, const Reply *reply) {
    FeedNews *news = &feed->news;
    const char *wrong = score_not_finite(&feed->canvas);
    pthread_mutex_lock(&feed->lock);
    Image old = feed->picture;
    feed->picture = feed->canvas;
    feed->canvas = old;
    news->pictures++;
    if (feed->setup.kind != FEED_TRUTH && (turn->renew || news->pictures == 1))
        feed->again = WARM_UP;
    else if (feed->again > 0)
        feed->again--;
    news->answered = turn->number;
    news->turn = process_now() - turn->start;
    memcpy(news->milliseconds, reply->milliseconds, sizeof news->milliseconds);
    snprintf(news->warning, sizeof news->warning, "%s", reply->message);
    if (wrong)
        check_append(news->warning, sizeof news->warning, "%s%s", reply->message[0] ? "\n" : "", wrong);
    if (turn->renew)
        news->outdated = false;
    if (!news->outdated)
        news->problem[0] = '\0';
    pthread_mutex_unlock(&feed->lock);
}

// A request that could not be drawn. What is wrong with newer files is not forgotten over it.
static void publish_problem(Feed *feed, const Turn *turn, const char *problem, bool dead) {
    FeedNews *news = &feed->news;
    pthread_mutex_lock(&feed->lock);
    news->answered = turn->number;
    news->dead = dead;
    feed->again = 0;
    if (turn->renew)
        news->outdated = news->pictures > 0;
    if (turn->renew || !news->outdated)
        snprintf(news->problem, sizeof news->problem, "%s", problem);
    pthread_mutex_unlock(&feed->lock);
}

static bool superseded(Feed *feed) {
    pthread_mutex_lock(&feed->lock);
    bool is = feed->renew || feed->quit;
    pthread_mutex_unlock(&feed->lock);
    return is;
}

static void end_turn(Feed *feed) {
    pthread_mutex_lock(&feed->lock);
    feed->news.busy_since = 0;
    feed->news.building = false;
    pthread_mutex_unlock(&feed->lock);
    feed->setup.wake();
}

// Makes the folder that the client draws from. False with a message, or gcc's words.
static bool build(const Feed *feed, Client *client, char log[COMPILE_LOG]) {
    const FeedSetup *setup = &feed->setup;
    log[0] = '\0';
    if (setup->kind == FEED_REFERENCE)
        return derive_ours(client->folder, setup->rubric, (Solved){SOLVED_ALL, NULL}, NULL);
    const char *earlier = feed->clients[feed->current].folder;
    return files_make_temporary(client->folder) &&
           derive_again(client->folder, earlier[0] ? earlier : NULL, setup->rubric, setup->submission, log);
}

static void discard(const Feed *feed, Client *client) {
    client_stop(client);
    if (feed->setup.kind == FEED_MINE && client->folder[0])
        files_remove(client->folder);
    client->folder[0] = '\0';
}

static void prepare(const Feed *feed, Client *client) {
    memset(client, 0, sizeof *client);
    client->trust = feed->setup.kind == FEED_MINE ? TRUST_NOBODY : TRUST_OURS;
    client->context = feed->setup.context;
    client->seconds = feed->setup.kind == FEED_MINE ? feed->setup.seconds : OURS_SECONDS;
    client->each_turn = true;
}

// Only what this lab knows: the tables of mine and of the reference may differ.
static void keep_known_knobs(const Description *known, Request *request) {
    int kept = 0;
    for (int i = 0; i < request->knob_count; i++)
        for (int k = 0; k < known->knob_count; k++)
            if (strcmp(known->knobs[k].name, request->knobs[i].name) == 0) {
                request->knobs[kept++] = request->knobs[i];
                break;
            }
    request->knob_count = kept;
}

// Says which worker is being waited for, -1 for none, so that it can be cancelled.
static void wait_for(Feed *feed, int client) {
    pthread_mutex_lock(&feed->lock);
    feed->drawing = client;
    feed->news.building = false;
    pthread_mutex_unlock(&feed->lock);
}

static DrawResult draw_with(Feed *feed, int client, const Turn *turn, Reply *reply) {
    Request request = turn->request;
    snprintf(request.folder, sizeof request.folder, "%.1000s", feed->clients[client].folder);
    if (feed->setup.kind != FEED_TRUTH)
        keep_known_knobs(&feed->descriptions[client], &request);
    wait_for(feed, client);
    client_begin(&feed->clients[client]);
    DrawResult result = client_draw(&feed->clients[client], &request, &feed->canvas, reply);
    wait_for(feed, -1);
    return result;
}

static DrawResult describe(Feed *feed, int client, Reply *reply) {
    const Request request = {.magic = PROTOCOL_MAGIC};
    wait_for(feed, client);
    DrawResult result = client_describe(&feed->clients[client], &request, &feed->descriptions[client], reply);
    wait_for(feed, -1);
    return result;
}

static void adopt(Feed *feed, int candidate) {
    discard(feed, &feed->clients[feed->current]);
    feed->current = candidate;
    pthread_mutex_lock(&feed->lock);
    feed->news.dead = false;
    feed->news.described++;
    feed->news.description = feed->descriptions[candidate];
    pthread_mutex_unlock(&feed->lock);
}

// Builds the new files and lets them draw. What went wrong stands in reply->message, then gcc's words in
// `log`.
static DrawResult try_new(Feed *feed, int candidate, const Turn *turn, Reply *reply, char log[COMPILE_LOG]) {
    Client *client = &feed->clients[candidate];
    check_clear();
    memset(reply, 0, sizeof *reply);
    prepare(feed, client);
    if (!build(feed, client, log) || !client_start(client)) {
        snprintf(reply->message, sizeof reply->message, "%s", check_message());
        return DRAW_LOST;
    }
    DrawResult result = describe(feed, candidate, reply);
    return result == DRAW_OK && turn->number ? draw_with(feed, candidate, turn, reply) : result;
}

// Changes over to new files when they draw, or when nothing else would.
static void renew(Feed *feed, const Turn *turn) {
    static _Thread_local char log[COMPILE_LOG];
    static _Thread_local Reply reply;
    int candidate = 1 - feed->current;
    DrawResult result = try_new(feed, candidate, turn, &reply, log);
    if (result == DRAW_OK || (result == DRAW_FAILED && !feed->clients[feed->current].started))
        adopt(feed, candidate);
    else
        discard(feed, &feed->clients[candidate]);
    check_append(reply.message, sizeof reply.message, "%s%s", reply.message[0] && log[0] ? "\n" : "", log);
    if (result == DRAW_OK && turn->number)
        publish(feed, turn, &reply);
    else if (result != DRAW_OK)
        publish_problem(feed, turn, superseded(feed) ? "" : reply.message,
                        !feed->clients[feed->current].started);
}

static void draw(Feed *feed, const Turn *turn) {
    static _Thread_local Reply reply;
    check_clear();
    DrawResult result = draw_with(feed, feed->current, turn, &reply);
    if (result == DRAW_OK) {
        publish(feed, turn, &reply);
        return;
    }
    bool dead = result != DRAW_FAILED;
    if (dead)
        discard(feed, &feed->clients[feed->current]);
    publish_problem(feed, turn, superseded(feed) ? "" : reply.message, dead);
}

static void *run(void *context) {
    Feed *feed = context;
    static _Thread_local Turn turn;
    while (next_turn(feed, &turn)) {
        if (turn.renew && feed->setup.kind != FEED_TRUTH)
            renew(feed, &turn);
        else
            draw(feed, &turn);
        end_turn(feed);
    }
    discard(feed, &feed->clients[0]);
    discard(feed, &feed->clients[1]);
    return NULL;
}

bool feed_start(Feed *feed, const FeedSetup *setup) {
    char worker[FILES_PATH];
    memset(feed, 0, sizeof *feed);
    feed->setup = *setup;
    feed->renew = setup->kind != FEED_TRUTH;
    feed->drawing = -1;
    home_build_path(worker, "truth_worker");
    if (setup->kind == FEED_TRUTH) {
        if (!files_exists(worker))
            return check_fail("no truth here: it needs Embree (common/setup --test), then make run again");
        prepare(feed, &feed->clients[0]);
        snprintf(feed->clients[0].folder, sizeof feed->clients[0].folder, "-");
        feed->clients[0].program = "truth_worker";
    }
    pthread_mutex_init(&feed->lock, NULL);
    pthread_cond_init(&feed->work, NULL);
    feed->running = pthread_create(&feed->thread, NULL, run, feed) == 0;
    return feed->running || check_fail("no thread can be started");
}

// Ends what a worker is drawing. Under the lock.
static void cancel(Feed *feed) {
    if (feed->drawing >= 0)
        feed->clients[feed->drawing].process.cancelled = true;
}

void feed_stop(Feed *feed) {
    if (!feed->running)
        return;
    pthread_mutex_lock(&feed->lock);
    feed->quit = true;
    cancel(feed);
    pthread_cond_signal(&feed->work);
    pthread_mutex_unlock(&feed->lock);
    pthread_join(feed->thread, NULL);
    pthread_mutex_destroy(&feed->lock);
    pthread_cond_destroy(&feed->work);
    image_destroy(&feed->picture);
    image_destroy(&feed->canvas);
    feed->running = false;
}

void feed_ask(Feed *feed, const Request *request, uint64_t number) {
    pthread_mutex_lock(&feed->lock);
    feed->request = *request;
    feed->asked = number;
    pthread_cond_signal(&feed->work);
    pthread_mutex_unlock(&feed->lock);
}

void feed_renew(Feed *feed) {
    pthread_mutex_lock(&feed->lock);
    feed->renew = true;
    pthread_cond_signal(&feed->work);
    pthread_mutex_unlock(&feed->lock);
}

void feed_look(Feed *feed, FeedNews *news) {
    pthread_mutex_lock(&feed->lock);
    *news = feed->news;
    if (feed->renew && news->busy_since > 0 && process_now() - news->busy_since > PATIENCE)
        cancel(feed);
    pthread_mutex_unlock(&feed->lock);
}

bool feed_take(Feed *feed, Image *picture) {
    pthread_mutex_lock(&feed->lock);
    bool ok = feed->picture.rgba && image_copy(picture, &feed->picture);
    pthread_mutex_unlock(&feed->lock);
    return ok;
}
