#include "worker/stage_view.h"

#include "draw.h"
#include "gl_state.h"

enum { MOST_STRETCHED = 8 };
static const float GROUND = 40 / 255.0F;

bool stage_view_create(StageView *view) {
    if (!program_create(&view->program, &(ProgramFiles){"fullscreen.vert", "stage.frag", NULL}))
        return false;
    glGenSamplers(1, &view->sampler);
    glSamplerParameteri(view->sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(view->sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(view->sampler, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    return true;
}

static bool is_depth(GLuint texture) {
    GLint bits = 0;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &bits);
    return bits > 0;
}

void stage_view_measure(GLuint texture, FrameFacts *facts) {
    if (!glIsTexture(texture))
        return;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &facts->stage_width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &facts->stage_height);
}

// Lets the viewport have the texture's shape, on grey; one much longer than wide would hardly be seen in it.
static void keep_shape(const Target *target, GLuint texture) {
    FrameFacts size = {0};
    stage_view_measure(texture, &size);
    const long width = size.stage_width, height = size.stage_height;
    if (width < 1 || height < 1 || width > MOST_STRETCHED * height || height > MOST_STRETCHED * width)
        return;
    const bool wide = width * target->height > height * target->width;
    const int across = wide ? target->width : (int)(width * target->height / height),
              down = wide ? (int)(height * target->width / width) : target->height;
    glClearColor(GROUND, GROUND, GROUND, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport((target->width - across) / 2, (target->height - down) / 2, across, down);
}

void stage_view_draw(const StageView *view, const Target *target, GLuint texture, bool own_shape) {
    gl_reset();
    target_bind(target);
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!glIsTexture(texture))
        return;
    if (own_shape)
        keep_shape(target, texture);
    glDisable(GL_DEPTH_TEST);
    program_set_int(&view->program, "u_is_depth", is_depth(texture));
    program_set_texture(&view->program, "u_texture", 0, GL_TEXTURE_2D, texture);
    glBindSampler(0, view->sampler);
    draw_fullscreen(&view->program);
    glBindSampler(0, 0);
}
