#include "study/counted_costs.h"

#include "scene/check.h"
#include "study/chart_svg.h"
#include "study/verdict.h"

#include <stdio.h>
#include <string.h>

static WorkerClient client_of(const LabArtist *artist) {
    WorkerClient client = {.trust = artist->painter ? TRUST_OURS : TRUST_NOBODY,
                           .jail = artist->client.jail,
                           .quick_shaders = true,
                           .seconds = artist->client.seconds};
    snprintf(client.folder, sizeof client.folder, "%s",
             artist->painter ? artist->painter->folder : artist->client.folder);
    return client;
}

static bool count(const LabArtist *artist, Request *request, FrameCounts *counts) {
    static Reply reply;
    static Image image;
    WorkerClient client = client_of(artist);
    request->counted = COUNTED_READS;
    request->fresh = 1;
    const bool drawn = worker_client_draw(&client, request, &image, &reply) == DRAW_OK;
    worker_client_stop(&client);
    *counts = reply.counts;
    return drawn ||
           check_fail("lab %s does not draw while it is counted: %s", artist->rubric.id, reply.message);
}

static bool count_finding(Finding *finding, const SceneFindings *findings, LabArtists *artists) {
    static Scene scene;
    FrameCounts counts;
    const double pixels = (double)findings->size.width * findings->size.height;
    const LabArtist *artist = lab_artists_get(artists, &finding->method);
    views_make(findings->scene, 0, &scene);
    Request request = setting_request(&finding->method.setting, &scene, findings->size);
    if (!artist || !count(artist, &request, &counts))
        return false;
    finding->cost.taps = counts.taps / pixels;
    finding->cost.fragments = counts.fragments;
    finding->cost.texels = counts.texels;
    finding->cost.counted = counts.taps + counts.fragments + counts.texels;
    return true;
}

// The same findings with the counted cost a pixel in the place of times, and without rays; judged by it.
static void put_costs_for_times(const SceneFindings *findings, SceneFindings *made) {
    const double pixels = (double)findings->size.width * findings->size.height;
    *made = *findings;
    made->count = 0;
    for (int i = 0; i < findings->count; i++) {
        if (findings->findings[i].method.rays > 0)
            continue;
        Point point = findings->points[i];
        point.mad = 0;
        point.ms = point.ms < 0 ? point.ms : findings->findings[i].cost.counted / pixels;
        made->findings[made->count] = findings->findings[i];
        made->points[made->count++] = point;
    }
    findings_judge(made);
}

bool counted_costs(SceneFindings *findings, LabArtists *artists, const char *folder) {
    static SceneFindings made;
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        if (finding->drawn && finding->method.rays == 0 && !count_finding(finding, findings, artists))
            return false;
    }
    put_costs_for_times(findings, &made);
    return chart_draw(&made, CHART_COST, folder);
}
