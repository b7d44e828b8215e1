// Puts back each state of OpenGL 4.1 that a lab can leave changed, group after group, to what the standard
// says a new context has. Hundreds of calls, several times a frame, of which none can fail: straight to the
// driver, and only the last one asks for errors.
#include "gl_state.h"

#include "scene/count.h"

static GLuint limit_of(GLenum name) {
    GLint value = 0;
    glad_glGetIntegerv(name, &value);
    return value > 0 ? (GLuint)value : 0;
}

// What holds up other calls, or keeps them from having an effect, comes first.
static void end_what_runs(void) {
    static const GLenum targets[] = {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED,
                                     GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN};
    glad_glEndConditionalRender(); // an error where none runs, which nothing can ask
    glad_glGetError();
    if (limit_of(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE))
        glad_glEndTransformFeedback();
    for (unsigned i = 0; i < COUNT(targets); i++) {
        bool indexed = i >= 3;
        for (GLuint stream = 0; stream < (indexed ? limit_of(GL_MAX_VERTEX_STREAMS) : 1); stream++) {
            GLint query = 0;
            glad_glGetQueryIndexediv(targets[i], stream, GL_CURRENT_QUERY, &query);
            if (query)
                glad_glEndQueryIndexed(targets[i], stream);
        }
    }
}

static void unbind_textures(void) {
    static const GLenum targets[] = {GL_TEXTURE_1D,
                                     GL_TEXTURE_2D,
                                     GL_TEXTURE_3D,
                                     GL_TEXTURE_1D_ARRAY,
                                     GL_TEXTURE_2D_ARRAY,
                                     GL_TEXTURE_RECTANGLE,
                                     GL_TEXTURE_CUBE_MAP,
                                     GL_TEXTURE_CUBE_MAP_ARRAY,
                                     GL_TEXTURE_BUFFER,
                                     GL_TEXTURE_2D_MULTISAMPLE,
                                     GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
    const GLuint units = limit_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    glad_glActiveTexture(GL_TEXTURE0);
    if (gl_unbind_textures(units))
        return;
    for (GLuint unit = 0; unit < units; unit++) {
        glad_glActiveTexture(GL_TEXTURE0 + unit);
        for (unsigned i = 0; i < COUNT(targets); i++)
            glad_glBindTexture(targets[i], 0);
        glad_glBindSampler(unit, 0);
    }
    glad_glActiveTexture(GL_TEXTURE0);
}

static void unbind_buffers(void) {
    static const GLenum targets[] = {GL_ARRAY_BUFFER,         GL_COPY_READ_BUFFER,  GL_COPY_WRITE_BUFFER,
                                     GL_DRAW_INDIRECT_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER,
                                     GL_TEXTURE_BUFFER};
    const GLuint uniform = limit_of(GL_MAX_UNIFORM_BUFFER_BINDINGS);
    const GLuint feedback = limit_of(GL_MAX_TRANSFORM_FEEDBACK_BUFFERS);
    for (unsigned i = 0; i < COUNT(targets); i++)
        glad_glBindBuffer(targets[i], 0);
    for (GLuint i = 0; i < uniform; i++)
        glad_glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
    for (GLuint i = 0; i < feedback; i++)
        glad_glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, 0);
}

static void unbind_objects(void) {
    glad_glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    glad_glUseProgram(0);
    glad_glBindProgramPipeline(0);
    glad_glBindVertexArray(0);
    glad_glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_forget_framebuffer();
    glad_glBindRenderbuffer(GL_RENDERBUFFER, 0);
    unbind_buffers();
    unbind_textures();
}

static void switch_all(void) {
    static const GLenum off[] = {GL_BLEND,
                                 GL_COLOR_LOGIC_OP,
                                 GL_DEPTH_CLAMP,
                                 GL_FRAMEBUFFER_SRGB,
                                 GL_LINE_SMOOTH,
                                 GL_POLYGON_OFFSET_FILL,
                                 GL_POLYGON_OFFSET_LINE,
                                 GL_POLYGON_OFFSET_POINT,
                                 GL_POLYGON_SMOOTH,
                                 GL_PRIMITIVE_RESTART,
                                 GL_PROGRAM_POINT_SIZE,
                                 GL_RASTERIZER_DISCARD,
                                 GL_SAMPLE_ALPHA_TO_COVERAGE,
                                 GL_SAMPLE_ALPHA_TO_ONE,
                                 GL_SAMPLE_COVERAGE,
                                 GL_SAMPLE_MASK,
                                 GL_SAMPLE_SHADING,
                                 GL_SCISSOR_TEST,
                                 GL_STENCIL_TEST,
                                 GL_TEXTURE_CUBE_MAP_SEAMLESS};
    static const GLenum on[] = {GL_DEPTH_TEST, GL_CULL_FACE, GL_DITHER, GL_MULTISAMPLE};
    for (unsigned i = 0; i < COUNT(off); i++)
        glad_glDisable(off[i]);
    for (GLuint i = 0; i < limit_of(GL_MAX_CLIP_DISTANCES); i++)
        glad_glDisable(GL_CLIP_DISTANCE0 + i);
    for (unsigned i = 0; i < COUNT(on); i++)
        glad_glEnable(on[i]);
}

static void reset_pixel_store(void) {
    static const GLenum zero[] = {GL_PACK_SWAP_BYTES,    GL_PACK_LSB_FIRST,      GL_PACK_ROW_LENGTH,
                                  GL_PACK_IMAGE_HEIGHT,  GL_PACK_SKIP_ROWS,      GL_PACK_SKIP_PIXELS,
                                  GL_PACK_SKIP_IMAGES,   GL_UNPACK_SWAP_BYTES,   GL_UNPACK_LSB_FIRST,
                                  GL_UNPACK_ROW_LENGTH,  GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS,
                                  GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES};
    for (unsigned i = 0; i < COUNT(zero); i++)
        glad_glPixelStorei(zero[i], 0);
    glad_glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glad_glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glad_glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
}

static void reset_geometry(void) {
    glad_glPatchParameteri(GL_PATCH_VERTICES, 3);
    glad_glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, (float[]){1, 1, 1, 1});
    glad_glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, (float[]){1, 1});
    glad_glPrimitiveRestartIndex(0);
    glad_glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    for (GLuint i = 0; i < limit_of(GL_MAX_VERTEX_ATTRIBS); i++)
        glad_glVertexAttrib4f(i, 0, 0, 0, 1);
    glad_glViewport(0, 0, 0, 0); // of all viewports, as the next two
    glad_glScissor(0, 0, 0, 0);
    glad_glDepthRange(0, 1);
}

static void reset_rasterizer(void) {
    glad_glCullFace(GL_BACK);
    glad_glFrontFace(GL_CCW);
    glad_glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glad_glPolygonOffset(0, 0);
    glad_glLineWidth(1);
    glad_glPointSize(1);
    glad_glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
    glad_glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
    glad_glSampleCoverage(1, GL_FALSE);
    glad_glMinSampleShading(0);
    for (GLuint i = 0; i < limit_of(GL_MAX_SAMPLE_MASK_WORDS); i++)
        glad_glSampleMaski(i, ~0u);
    static const GLenum hints[] = {GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_LINE_SMOOTH_HINT,
                                   GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT};
    for (unsigned i = 0; i < COUNT(hints); i++)
        glad_glHint(hints[i], GL_DONT_CARE);
}

static void reset_fragments(void) {
    glad_glDepthFunc(GL_LESS);
    glad_glDepthMask(GL_TRUE);
    glad_glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); // of all draw buffers, as the blending
    glad_glStencilMask(~0u);                              // of both faces
    glad_glStencilFunc(GL_ALWAYS, 0, ~0u);
    glad_glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glad_glBlendFunc(GL_ONE, GL_ZERO);
    glad_glBlendEquation(GL_FUNC_ADD);
    glad_glBlendColor(0, 0, 0, 0);
    glad_glLogicOp(GL_COPY);
    glad_glClearColor(0, 0, 0, 1);
    glad_glClearDepth(1);
    glClearStencil(0);
}

void gl_reset(void) {
    end_what_runs();
    unbind_objects();
    switch_all();
    reset_pixel_store();
    reset_geometry();
    reset_rasterizer();
    reset_fragments();
}

GLuint gl_create_grey_texture(void) {
    const GLint grey[] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, grey);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}
