#include "worker/ready_program.h"

#include "draw.h"
#include "gl_state.h"
#include "scene/check.h"
#include "scene/shader_source.h"
#include "target.h"

#include <string.h>

enum { SIDE = 64 };

static const ProgramFiles FILES = {"scene.vert", "empty.frag", NULL};
static Program program; // zeroed: there is none, or it was taken
static ShaderSource vertex, fragment;

// Of nothing, with every uniform 0: the driver compiles for the state in which it is asked to draw.
static void draw(const Target *map) {
    static const Scene nothing = {.object_count = 1};
    const Frame frame = {
        .scene = &nothing, .framebuffer = map->framebuffer, .width = SIDE, .height = SIDE, .view = "picture"};
    gl_reset();
    frame_bind(&frame);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_scene(&frame, &program, (mat4s){0}, nothing.camera.eye);
    gl_reset();
}

bool ready_program_create(void) {
    Target map = {0};
    const bool ok = shader_source_load(&vertex, FILES.vertex) &&
                    shader_source_load(&fragment, FILES.fragment) && program_create(&program, &FILES) &&
                    target_create(&map, SIDE, SIDE, 0, GL_DEPTH_COMPONENT24);
    if (ok)
        draw(&map);
    target_destroy(&map);
    return ok;
}

static bool same_text(const ShaderSource *ours, const char *name) {
    ShaderSource theirs;
    if (!shader_source_load(&theirs, name))
        return false;
    const bool same = strcmp(theirs.text, ours->text) == 0;
    shader_source_destroy(&theirs);
    return same;
}

bool ready_program_take(Program *taken, const ProgramFiles *files) {
    if (!program.id || files->geometry || !files->fragment || strcmp(files->vertex, FILES.vertex) != 0 ||
        strcmp(files->fragment, FILES.fragment) != 0)
        return false;
    const bool same = same_text(&vertex, FILES.vertex) && same_text(&fragment, FILES.fragment);
    check_clear();
    if (!same)
        return false;
    *taken = program;
    taken->files = *files;
    program = (Program){0};
    return true;
}
