// What a shadow volume needs of its caster: caps, a closed mesh, and one answer a face.
#include "scene/adjacency.h"
#include "rows_counting.h"
#include "truth/closed_scenes.h"

#include <stdlib.h>
#include <string.h>

enum { SIZE = COUNTING_SIZE };

// Each triangle is asked about from whatever corner comes first, as before task 7.10.
static const Change first_come = {
    .name = "corners in the order in which they come",
    .edits = {{"volume.geom", "i < 2 && (before(b, a) || before(c, a)); i++", "i < 0; i++"}},
    .edit_count = 1};

static bool in_box(const Object *box, vec3s point) {
    vec3s p = glms_mat4_mulv3(glms_mat4_inv(box->world_from_object), point, 1);
    return fmaxf(fmaxf(fabsf(p.x), fabsf(p.y)), fabsf(p.z)) < 1;
}

// Does the ray go on from the box into its shadow? Else it leaves through a lit face, whose cap would be
// missing, too.
static bool meets_shadow(const Scene *casters, vec3s from, vec3s ray) {
    const float step = 0.01f;
    for (int i = 1; i <= 400; i++) {
        vec3s point = glms_vec3_add(from, glms_vec3_scale(ray, step * (float)i));
        if (!in_box(&casters->objects[0], point) && sight_holds(casters, point))
            return true;
    }
    return false;
}

// The pixels of the box (object 1) that light reaches and behind which lies its shadow: of the volume's two
// faces there the near cap is missing.
static SightShare half_counted(const Probe *probe) {
    static uint8_t flags[SIZE * SIZE];
    const Scene casters = sight_casters(&probe->truth_view.truth.scene);
    for (int i = 0; i < SIZE * SIZE; i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        vec3s ray = sight_ray(&casters.camera, probe->truth_view.size, i % SIZE, i / SIZE);
        flags[i] = hit->object == 1 && probe->truth_view.visibility[i] > 0.5f &&
                   meets_shadow(&casters, hit->position, ray);
    }
    return sight_share(probe, flags);
}

static bool sweep_near_caps(const Counting *method, bool fails) {
    bool ok = true;
    for (int angle = 0; ok && angle <= 75; angle += 15) {
        float a = glm_rad((float)angle);
        Scene scene = closed_wall(6, 10, glm_rad(40));
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 2), vec3_make(0.8f, 0.8f, 0.8f), 25);
        closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(10 * sinf(a), 2, 10 * cosf(a)), vec3_make(0, 0, 0),
                     0, 10, 1, 20);
        Probe probe;
        ok = counting_begin(&probe, method, &scene);
        if (ok) {
            SightShare share = fails ? half_counted(&probe) : sight_share(&probe, NULL);
            counting_add(method, &probe, angle, share, 0);
        }
        probe_end(&probe);
    }
    return ok;
}

// A lamp beside the eye by `x`: rays that end in the far cap never leave the shadow.
static bool sweep_far_caps(const Counting *method, bool fails) {
    bool ok = true;
    for (int i = 0; ok && i <= 8; i++) {
        double x = 0.45 * i;
        Scene scene = closed_wall(6, 10, glm_rad(40));
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 3), vec3_make(0.8f, 0.8f, 0.1f), 0);
        closed_light(&scene, LIGHT_SPOT, vec3_make((float)x, 0, 7), vec3_make(0, 0, 0), glm_rad(90), 0, 1,
                     20);
        Probe probe;
        SightShare share = {0};
        ok = counting_begin(&probe, method, &scene);
        if (ok && !fails)
            share = sight_share(&probe, NULL);
        ok = ok && (!fails || sight_share_at(&probe, INFINITY, &share));
        if (ok)
            counting_add(method, &probe, x, share, 0);
        probe_end(&probe);
    }
    return ok;
}

static bool run_caps(LabSet *labs, Findings *findings) {
    Figure *near_figure = findings_figure(findings, "Without near caps", "angle of the light (degrees)",
                                          "wrong pixels (share)"),
           *far_figure = findings_figure(findings, "Without far caps",
                                         "distance of the lamp from the line of sight (world units)",
                                         "wrong pixels (share)");
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    const Change *near_caps = artist ? rubric_mistake(&artist->rubric, "the near caps are missing") : NULL,
                 *far_caps = artist ? rubric_mistake(&artist->rubric, "the far caps are missing") : NULL;
    const Counting near[] = {
        {labs, findings, figure_curve(near_figure, "failure: z-fail", CURVE_EQUAL), near_caps, Z_FAIL, 0},
        {labs, findings, figure_curve(near_figure, "z-pass does without", CURVE_EQUAL), near_caps, Z_PASS, 2},
        {labs, findings, figure_curve(near_figure, "remedy: z-fail with caps", CURVE_EQUAL), NULL, Z_FAIL,
         2}};
    const Counting far[] = {
        {labs, findings, figure_curve(far_figure, "failure: z-fail", CURVE_EQUAL), far_caps, Z_FAIL, 1},
        {labs, findings, figure_curve(far_figure, "z-pass does without", CURVE_EQUAL), far_caps, Z_PASS, 2},
        {labs, findings, figure_curve(far_figure, "remedy: z-fail with caps", CURVE_EQUAL), NULL, Z_FAIL, 2}};
    bool ok = near_caps && far_caps;
    for (int i = 0; ok && i < 3; i++)
        ok = sweep_near_caps(&near[i], i == 0) && sweep_far_caps(&far[i], i == 0);
    return ok;
}

// The first `missing` triangles of a box are left out. Two make a side, and the first two sides lie opposite.
static bool count_open_edges(Curve *curve) {
    static const int by_hand[] = {0, 3, 4, 7, 8};
    bool ok = true;
    for (int missing = 0; ok && missing <= 4; missing++) {
        Mesh mesh;
        Adjacency adjacency = {0};
        ok = mesh_create(&mesh, SHAPE_BOX);
        if (!ok)
            break;
        mesh.index_count -= 3 * missing;
        memmove(mesh.indices, mesh.indices + 3 * missing, (size_t)mesh.index_count * sizeof *mesh.indices);
        ok = adjacency_create(&adjacency, &mesh);
        curve_add(curve, missing, adjacency.open_edges, by_hand[missing], 0);
        adjacency_destroy(&adjacency);
        mesh_destroy(&mesh);
    }
    return ok;
}

// A caster before the wall, turned about +y; `quad`: an open one, else a closed board.
static bool sweep_turns(const Counting *method, bool quad) {
    bool ok = true;
    for (int turn = 10; ok && turn <= 170; turn += 20) {
        Scene scene = closed_wall(6, 10, glm_rad(40));
        closed_add(&scene, quad ? SHAPE_PLANE : SHAPE_BOX, vec3_make(0.8f, 0, 3), vec3_make(1, 1, 1),
                   (float)turn);
        mat4s *placed = &scene.objects[1].world_from_object;
        *placed = glms_rotate(*placed, glm_rad(90), vec3_make(1, 0, 0));
        *placed = glms_scale(*placed, vec3_make(0.7f, 0.01f, 0.7f));
        closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(6, 0, 10), vec3_make(0, 0, 0), 0, 10, 1, 20);
        Probe probe;
        ok = counting_begin(&probe, method, &scene);
        if (ok) {
            curve_add(method->curve, turn, probe_false(&probe, 0, 1), quad ? 1 : 0, 0);
            counting_frame(method, &probe, turn, probe.measured.metrics.all.mae);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_open(LabSet *labs, Findings *findings) {
    Figure *edges = findings_figure(findings, "The checker: a box with triangles left out",
                                    "triangles left out", "open edges"),
           *turns = findings_figure(findings, "A caster that is turned",
                                    "turn of the caster about the vertical (degrees)",
                                    "false light on the shadow (share)");
    return count_open_edges(figure_curve(edges, "counted by hand: 0, 3, 4, 7, 8", CURVE_EQUAL)) &&
           sweep_turns(&(Counting){labs, findings,
                                   figure_curve(turns, "failure: one-sided quad", CURVE_EQUAL), NULL, Z_FAIL,
                                   0},
                       true) &&
           sweep_turns(&(Counting){labs, findings, figure_curve(turns, "remedy: closed board", CURVE_EQUAL),
                                   NULL, Z_FAIL, 1},
                       false);
}

// A box on the wall, with a side in whose plane the lamp lies but for a `step`.
static Scene grazed_box(int step) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    const vec3s lamp = vec3_make(0.3f, -5, 6);
    const float x = -0.8f + 1e-6f * (float)step, along = atan2f(x - lamp.x, 5);
    const vec3s side = vec3_make(cosf(along), -sinf(along), 0);
    const vec3s center = glms_vec3_add(vec3_make(x, 0, 0.6f), glms_vec3_scale(side, 0.2f));
    closed_add(&scene, SHAPE_BOX, center, vec3_make(1, 1, 1), 0);
    mat4s *placed = &scene.objects[1].world_from_object;
    *placed = glms_rotate(glms_translate_make(center), -along, vec3_make(0, 0, 1));
    *placed = glms_scale(*placed, vec3_make(0.2f, 0.3f, 0.6f));
    closed_light(&scene, LIGHT_SPOT, lamp, vec3_make(0, 0, 0), glm_rad(90), 0, 1, 20);
    return scene;
}

// Adds up the wrong pixels that are no edge.
static bool sweep_grazing(const Counting *method) {
    double leaking = 0;
    bool ok = true;
    for (int step = -CURVE_POINTS / 2; ok && step < CURVE_POINTS / 2; step++) {
        const Scene scene = grazed_box(step);
        Probe probe;
        ok = counting_begin(&probe, method, &scene);
        const Metrics *metrics = &probe.measured.metrics;
        leaking += ok ? metrics->interior.mae * (double)metrics->all.pixels : 0;
        curve_add(method->curve, step, leaking, 0, 0);
        counting_frame(method, &probe, step, probe.measured.metrics.all.mae);
        probe_end(&probe);
    }
    return ok;
}

static bool run_silhouette(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "The side of a box moves through the lamp's place",
                                     "step (millionths of a world unit)", "leaking pixels so far");
    return sweep_grazing(&(Counting){labs, findings,
                                     figure_curve(figure, "failure: corners as they come", CURVE_RISING),
                                     &first_come, Z_FAIL, 0}) &&
           sweep_grazing(&(Counting){labs, findings,
                                     figure_curve(figure, "remedy: corners in one order", CURVE_EQUAL), NULL,
                                     Z_FAIL, 1}) &&
           sweep_grazing(&(Counting){labs, findings,
                                     figure_curve(figure, "remedy: sides found on the CPU", CURVE_EQUAL),
                                     NULL, Z_FAIL_CPU, 2});
}

const Row LAB_TABLE[] = {
    {23, "caps", "z-fail, z-pass", "the light around the caster, without near and without far caps",
     "Z-fail needs both: without near caps, the caster's lit faces are dark (but where a ray goes in and out "
     "by two of them: then both counts are missing); without far caps, rays that never leave a shadow "
     "through its side are lit. Z-pass never sees a cap: near caps lie on "
     "the caster's surface, far caps behind everything.",
     "closed form: the caster's lit pixels; rays from the lamp against the caster", run_caps},
    {24, "open meshes", "z-fail", "triangles left out of a box; a quad turned half round",
     "The checker counts the edges without a neighbour. A caster with such edges has no inside, so it gets "
     "no "
     "volume: a single quad casts no shadow at all, whichever way it is turned. A closed board does, however "
     "thin it is.",
     "count by hand; the traced shadow", run_open},
    {25, "silhouettes", "z-fail", "the plane of the caster's side moves through the lamp's place",
     "A triangle is asked whether it faces the light by itself and by its three neighbours. When rounding "
     "gives them different answers, the volume has a hole through which a whole stripe leaks. With the "
     "corners sorted first, all hear the same answer; the CPU sorts by the numbers of the vertices.",
     "the traced shadow", run_silhouette},
    {0},
};
