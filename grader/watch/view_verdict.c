// Asks the process that grades, and turns what it says into one line.
#include "watch/view_verdict.h"

#include "scene/check.h"

#include <poll.h>
#include <string.h>

static void write_line(const LabVerdict *verdict, App *app) {
    app->verdict[0] = '\0';
    if (verdict->fault || verdict->message[0]) // the window says by itself what does not compile or crashes
        return;
    check_append(app->verdict, sizeof app->verdict, "=> %s",
                 verdict->more         ? "looking for the cause ..."
                 : verdict->summary[0] ? verdict->summary
                 : verdict->done       ? "all checks pass"
                                       : "");
}

static bool begin(ViewVerdict *verdict, App *app) {
    if (verdict->grading.pid == 0)
        verdict->grading.options = (GradingOptions){.lab_folder = app->folder,
                                                    .rubrics = &app->rubric,
                                                    .seed = app->options->seed,
                                                    .context = app->options->context,
                                                    .seconds = 2 * app->options->seconds};
    verdict->described = app->news[FEED_MINE].described;
    verdict->off = !grading_process_ask(&verdict->grading, 0);
    check_clear();
    app->verdict[0] = '\0';
    return !verdict->off;
}

// Grading takes a processor that the first picture needs.
static bool can_begin(const FeedNews *mine) {
    return mine->pictures > 0 || mine->problem[0];
}

bool view_verdict_tick(ViewVerdict *verdict, App *app) {
    const uint64_t described = app->news[FEED_MINE].described;
    if (verdict->off || !app->state.text || !app->rubric.json)
        return false;
    if (!verdict->grading.busy)
        return described != verdict->described && can_begin(&app->news[FEED_MINE]) && begin(verdict, app);
    struct pollfd news = {.fd = verdict->grading.verdicts, .events = POLLIN};
    if (poll(&news, 1, 0) <= 0 || !grading_process_take(&verdict->grading))
        return false;
    if (described == verdict->described) // else it is of older files, and the next one is asked for at once
        write_line(&verdict->grading.verdict, app);
    return true;
}

void view_verdict_stop(ViewVerdict *verdict) {
    grading_process_stop(&verdict->grading);
}
