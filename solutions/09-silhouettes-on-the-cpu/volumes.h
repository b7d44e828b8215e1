// Given: the volumes of a frame's casters, measured from the eye.
#pragma once

#include "around_eye.h"

enum { KNOB_METHOD, KNOB_SILHOUETTES, KNOB_STRETCH };
enum { FROM_ZERO, FROM_EYE, Z_FAIL };
enum { PROGRAM_LIGHT, PROGRAM_VOLUME, PROGRAM_CONSTANT };

static struct {
    Caster casters[SHAPE_COUNT][2]; // as they are, and turned inside out
    Edge *edges;                    // room for those of one caster
    Shell lit, fins, sides, caps;
    int around_eye, of_object[SCENE_MAX_OBJECTS]; // volumes that hold the eye: of all objects, and of each
    GLuint array, buffer;
} volumes;

static bool volumes_create(void) {
    bool ok = casters_create();
    int most = 0;
    for (int i = 0; ok && i < 2 * SHAPE_COUNT; i++) {
        Caster *caster = &volumes.casters[i / 2][i % 2];
        ok = caster_create(caster, (Shape)(i / 2), i % 2);
        most = ok && caster->triangle_count > most ? caster->triangle_count : most;
    }
    volumes.edges = ok ? malloc(3 * (size_t)most * sizeof *volumes.edges) : NULL;
    glGenVertexArrays(1, &volumes.array);
    glGenBuffers(1, &volumes.buffer);
    return ok && (volumes.edges || check_fail("out of memory for %d edges", 3 * most));
}

static void volumes_destroy(void) {
    for (int i = 0; i < 2 * SHAPE_COUNT; i++)
        caster_destroy(&volumes.casters[i / 2][i % 2]);
    Shell *shells[] = {&volumes.lit, &volumes.fins, &volumes.sides, &volumes.caps};
    for (int i = 0; i < 4; i++)
        shell_destroy(shells[i]);
    free(volumes.edges);
    volumes.edges = NULL;
    glDeleteVertexArrays(1, &volumes.array);
    glDeleteBuffers(1, &volumes.buffer);
    volumes.array = volumes.buffer = 0;
    casters_destroy();
}

// Puts the caster's vertices to their places, and asks of each triangle once whether it is lit.
static void place_caster(Caster *caster, const Mesh *mesh, mat4s world_from_object, const Light *light) {
    caster->light = *light;
    for (int i = 0; i < caster->vertex_count; i++)
        caster->places[i] = glms_mat4_mulv3(world_from_object, mesh->vertices[i].position, 1);
    for (int t = 0; t < caster->triangle_count; t++)
        caster->lit[t] = faces_light(light, corner(caster, t, 0), corner(caster, t, 1), corner(caster, t, 2));
}

// A sheet has no inside: it is turned so that it looks to the light.
static Caster *place_object(const Object *object, const Light *light) {
    const Shape shape = (Shape)object->shape;
    Caster *caster = &volumes.casters[shape][0];
    place_caster(caster, casters_mesh(shape), object->world_from_object, light);
    if (casters_adjacency(shape)->open_edges == 0 || caster->lit[0])
        return caster;
    caster = &volumes.casters[shape][1];
    place_caster(caster, casters_mesh(shape), object->world_from_object, light);
    return caster;
}

// For the stages: the lit triangles, and a fin on each edge of the silhouette.
static void show_parts(const Caster *caster, const EdgeSet *set) {
    for (int t = 0; t < caster->triangle_count; t++)
        if (caster->lit[t])
            shell_add(&volumes.lit, glms_vec4(corner(caster, t, 0), 1), glms_vec4(corner(caster, t, 1), 1),
                      glms_vec4(corner(caster, t, 2), 1));
    for (int i = 0; i < set->count; i++) {
        vec3s a = caster->places[set->edges[i].a], b = caster->places[set->edges[i].b];
        vec3s middle = glms_vec3_scale(glms_vec3_add(a, b), 0.5f);
        vec3s away = glms_vec3_normalize(glms_vec3_negate(to_light(&caster->light, middle)));
        shell_add(&volumes.fins, glms_vec4(a, 1), glms_vec4(b, 1),
                  glms_vec4(glms_vec3_muladds(away, 0.3f, middle), 1));
    }
}

static void add_volume(const Frame *frame, int object, const Caster *caster, bool show) {
    EdgeSet set = {.edges = volumes.edges};
    float stretch = frame->knobs[KNOB_STRETCH];
    if (frame->knobs[KNOB_SILHOUETTES] > 0) {
        find_by_neighbours(&set, caster);
    } else {
        find_by_set(&set, caster);
    }
    for (int i = 0; i < set.count; i++)
        add_side(&volumes.sides, caster, set.edges[i], stretch);
    for (int t = 0; t < caster->triangle_count; t++)
        if (caster->lit[t])
            add_caps(&volumes.caps, caster, t, stretch);
    volumes.of_object[object] = count_around_eye(caster, stretch);
    volumes.around_eye += volumes.of_object[object];
    if (show)
        show_parts(caster, &set);
}

// Makes the volumes of all objects under light 0; `show`: with the parts for the stages. The frame is one of
// from_eye.
static void volumes_make(const Frame *frame, bool show) {
    volumes.lit.count = volumes.fins.count = volumes.sides.count = volumes.caps.count = volumes.around_eye =
        0;
    for (int i = 0; i < frame->scene->object_count; i++)
        add_volume(frame, i, place_object(&frame->scene->objects[i], &frame->scene->lights[0]), show);
}
