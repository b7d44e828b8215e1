// The thread of a feed and the lock around what it shares with the window: newest request in, last good
// picture out.
#include "window/feed.h"

#include "scene/check.h"
#include "score/score.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

enum { WARM_UP = 3 }; // frames until the times are true

static const double PATIENCE = 0.5; // seconds, with what is being drawn when new files are there

static void lock(Feed *feed) {
    pthread_mutex_lock(&feed->lock);
}

// The news may have changed.
static void unlock(Feed *feed) {
    feed->news.changes++;
    pthread_mutex_unlock(&feed->lock);
}

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
    lock(feed);
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
    unlock(feed);
    return goes_on;
}

static void publish(Feed *feed, const Turn *turn, const Reply *reply) {
    FeedNews *news = &feed->news;
    const char *wrong = score_not_finite(&feed->canvas);
    lock(feed);
    Image old = feed->picture;
    feed->picture = feed->canvas;
    feed->canvas = old;
    news->pictures++;
    if (feed->setup.drawer.kind != FEED_TRUTH && (turn->renew || news->pictures == 1))
        feed->again = WARM_UP;
    else if (feed->again > 0)
        feed->again--;
    news->answered = turn->number;
    news->turn = process_now() - turn->start;
    memcpy(news->milliseconds, reply->milliseconds, sizeof news->milliseconds);
    news->facts = reply->facts;
    snprintf(news->warning, sizeof news->warning, "%s", reply->message);
    if (wrong)
        check_append(news->warning, sizeof news->warning, "%s%s", reply->message[0] ? "\n" : "", wrong);
    if (turn->renew)
        news->outdated = false;
    if (!news->outdated)
        news->problem[0] = '\0';
    unlock(feed);
}

// A request that could not be drawn. What is wrong with newer files is not forgotten over it.
static void publish_problem(Feed *feed, const Turn *turn, const char *problem, bool dead) {
    FeedNews *news = &feed->news;
    lock(feed);
    news->answered = turn->number;
    news->dead = dead;
    feed->again = 0;
    if (turn->renew)
        news->outdated = news->pictures > 0;
    if (turn->renew || !news->outdated)
        snprintf(news->problem, sizeof news->problem, "%s", problem);
    unlock(feed);
}

static bool superseded(Feed *feed) {
    lock(feed);
    bool is = feed->renew || feed->quit;
    unlock(feed);
    return is;
}

static void end_turn(Feed *feed) {
    lock(feed);
    feed->news.busy_since = 0;
    feed->news.building = false;
    unlock(feed);
    feed->setup.wake();
}

// Says which worker is being waited for, -1 for none, so that it can be cancelled.
static void wait_for(Feed *feed, int client) {
    lock(feed);
    feed->drawing = client;
    feed->news.building = false;
    unlock(feed);
}

static DrawResult draw_with(Feed *feed, int drawer, const Turn *turn, Reply *reply) {
    wait_for(feed, drawer);
    DrawResult result = drawer_draw(&feed->drawers[drawer], &turn->request, &feed->canvas, reply);
    wait_for(feed, -1);
    return result;
}

static DrawResult describe(Feed *feed, int drawer, Reply *reply) {
    if (feed->setup.drawer.kind == FEED_TRUTH)
        return DRAW_OK;
    wait_for(feed, drawer);
    DrawResult result = drawer_describe(&feed->drawers[drawer], reply);
    wait_for(feed, -1);
    return result;
}

static void adopt(Feed *feed, int candidate) {
    drawer_stop(&feed->drawers[feed->current]);
    feed->current = candidate;
    lock(feed);
    feed->news.dead = false;
    feed->news.described++;
    feed->news.description = feed->drawers[candidate].table;
    unlock(feed);
}

// Builds the new files and lets them draw. What went wrong stands in reply->message, then gcc's words in
// `log`.
static DrawResult try_new(Feed *feed, int candidate, const Turn *turn, Reply *reply, char log[COMPILE_LOG]) {
    check_clear();
    memset(reply, 0, sizeof *reply);
    if (!drawer_start(&feed->drawers[candidate], &feed->setup.drawer, &feed->drawers[feed->current], log)) {
        snprintf(reply->message, sizeof reply->message, "%s", check_message());
        return DRAW_LOST;
    }
    DrawResult result = describe(feed, candidate, reply);
    return result == DRAW_OK && turn->number ? draw_with(feed, candidate, turn, reply) : result;
}

static bool draws(const Feed *feed) {
    return feed->drawers[feed->current].client.started;
}

// Changes over to new files when they draw, or when nothing else would.
static void renew(Feed *feed, const Turn *turn) {
    static _Thread_local char log[COMPILE_LOG];
    static _Thread_local Reply reply;
    int candidate = 1 - feed->current;
    DrawResult result = try_new(feed, candidate, turn, &reply, log);
    if (result == DRAW_OK || (result == DRAW_FAILED && !draws(feed)))
        adopt(feed, candidate);
    else
        drawer_stop(&feed->drawers[candidate]);
    check_append(reply.message, sizeof reply.message, "%s%s", reply.message[0] && log[0] ? "\n" : "", log);
    if (result == DRAW_OK && turn->number)
        publish(feed, turn, &reply);
    else if (result != DRAW_OK)
        publish_problem(feed, turn, superseded(feed) ? "" : reply.message, !draws(feed));
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
        drawer_stop(&feed->drawers[feed->current]);
    publish_problem(feed, turn, superseded(feed) ? "" : reply.message, dead);
}

static void *run(void *context) {
    Feed *feed = context;
    static _Thread_local Turn turn;
    while (next_turn(feed, &turn)) {
        if (turn.renew)
            renew(feed, &turn);
        else
            draw(feed, &turn);
        end_turn(feed);
    }
    drawer_stop(&feed->drawers[0]);
    drawer_stop(&feed->drawers[1]);
    return NULL;
}

bool feed_start(Feed *feed, const FeedSetup *setup) {
    memset(feed, 0, sizeof *feed);
    feed->setup = *setup;
    feed->renew = !setup->waits;
    feed->drawing = -1;
    if (setup->drawer.kind == FEED_TRUTH && !drawer_has_truth())
        return check_fail("no truth here: it needs Embree (common/setup --more), then make run again");
    pthread_mutex_init(&feed->lock, NULL);
    pthread_cond_init(&feed->work, NULL);
    feed->running = pthread_create(&feed->thread, NULL, run, feed) == 0;
    return feed->running || check_fail("no thread can be started");
}

// Ends what a worker is drawing. Under the lock.
static void cancel(Feed *feed) {
    if (feed->drawing >= 0)
        feed->drawers[feed->drawing].client.process.cancelled = true;
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
