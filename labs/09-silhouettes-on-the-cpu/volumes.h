// Given: the volumes of a frame's casters, measured from the eye.
#pragma once

#include "extrude.h"

enum { KNOB_METHOD, KNOB_SILHOUETTES, KNOB_STRETCH };
enum { FROM_ZERO, FROM_EYE, Z_FAIL };
enum { PROGRAM_LIGHT, PROGRAM_VOLUME, PROGRAM_CONSTANT };

static struct {
    Caster casters[SHAPE_COUNT][2]; // as they are, and turned inside out
    Edge *edges;                    // room for those of one caster
    Shell sides, caps;
    int around_eye, of_object[SCENE_MAX_OBJECTS]; // volumes that hold the eye: of all objects, and of each
    GLuint array, buffer;
} volumes;

static bool volumes_create(void) {
    bool ok = casters_create();
    int most = 0;
    for (int i = 0; ok && i < 2 * SHAPE_COUNT; i++) {
        Caster *caster = &volumes.casters[i / 2][i % 2];
        if (i % 2 && casters_adjacency((Shape)(i / 2))->open_edges == 0)
            continue; // only sheets are turned
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
    shell_destroy(&volumes.sides);
    shell_destroy(&volumes.caps);
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

static EdgeSet find_edges(const Frame *frame, const Caster *caster) {
    EdgeSet set = {.edges = volumes.edges};
    if (frame->knobs[KNOB_SILHOUETTES] > 0) {
        find_by_neighbours(&set, caster);
    } else {
        find_by_set(&set, caster);
    }
    return set;
}

// Makes the volumes of all objects under light 0. The frame is one of from_eye.
static void volumes_make(const Frame *frame) {
    float stretch = frame->knobs[KNOB_STRETCH];
    volumes.sides.count = volumes.caps.count = volumes.around_eye = 0;
    for (int i = 0; i < frame->scene->object_count; i++) {
        const Caster *caster = place_object(&frame->scene->objects[i], &frame->scene->lights[0]);
        const EdgeSet set = find_edges(frame, caster);
        for (int k = 0; k < set.count; k++)
            add_side(&volumes.sides, caster, set.edges[k], stretch);
        for (int t = 0; t < caster->triangle_count; t++)
            if (caster->lit[t])
                add_caps(&volumes.caps, caster, t, stretch);
        volumes.of_object[i] = count_around_eye(caster, stretch);
        volumes.around_eye += volumes.of_object[i];
    }
}

// Draws the triangles with the program of volume.vert and faces.frag.
static void shell_draw(const Frame *frame, const Shell *shell) {
    const Program *program = &frame->programs[PROGRAM_VOLUME];
    program_set_mat4(program, "u_world_from_object", glms_mat4_identity());
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    glBindVertexArray(volumes.array);
    glBindBuffer(GL_ARRAY_BUFFER, volumes.buffer);
    glBufferData(GL_ARRAY_BUFFER, shell->count * (GLsizeiptr)sizeof *shell->corners, shell->corners,
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    glDrawArrays(GL_TRIANGLES, 0, shell->count);
    glBindVertexArray(0);
}
