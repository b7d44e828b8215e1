// The states of OpenGL 4.1 that a lab can leave changed, one a line: how its value is asked for, the value's
// name, the index where it has one, and a statement that leaves it changed.
//
// ASK: get (glGet), indexed (glGetIntegeri_v), enabled (glIsEnabledi), range (glGetDoublei_v), unit (glGet,
// of a texture unit), query (the running query of a target and stream), attribute (the current value of one).
#pragma once

#define STATES_OF_SWITCHES(X)                                                                                \
    X(get, GL_BLEND, 0, glEnable(GL_BLEND))                                                                  \
    X(enabled, GL_BLEND, 1, glEnablei(GL_BLEND, 1))                                                          \
    X(get, GL_CLIP_DISTANCE0, 0, glEnable(GL_CLIP_DISTANCE0))                                                \
    X(get, GL_CLIP_DISTANCE7, 0, glEnable(GL_CLIP_DISTANCE7))                                                \
    X(get, GL_COLOR_LOGIC_OP, 0, glEnable(GL_COLOR_LOGIC_OP))                                                \
    X(get, GL_CULL_FACE, 0, glDisable(GL_CULL_FACE))                                                         \
    X(get, GL_DEPTH_CLAMP, 0, glEnable(GL_DEPTH_CLAMP))                                                      \
    X(get, GL_DEPTH_TEST, 0, glDisable(GL_DEPTH_TEST))                                                       \
    X(get, GL_DITHER, 0, glDisable(GL_DITHER))                                                               \
    X(get, GL_FRAMEBUFFER_SRGB, 0, glEnable(GL_FRAMEBUFFER_SRGB))                                            \
    X(get, GL_LINE_SMOOTH, 0, glEnable(GL_LINE_SMOOTH))                                                      \
    X(get, GL_MULTISAMPLE, 0, glDisable(GL_MULTISAMPLE))                                                     \
    X(get, GL_POLYGON_OFFSET_FILL, 0, glEnable(GL_POLYGON_OFFSET_FILL))                                      \
    X(get, GL_POLYGON_OFFSET_LINE, 0, glEnable(GL_POLYGON_OFFSET_LINE))                                      \
    X(get, GL_POLYGON_OFFSET_POINT, 0, glEnable(GL_POLYGON_OFFSET_POINT))                                    \
    X(get, GL_POLYGON_SMOOTH, 0, glEnable(GL_POLYGON_SMOOTH))                                                \
    X(get, GL_PRIMITIVE_RESTART, 0, glEnable(GL_PRIMITIVE_RESTART))                                          \
    X(get, GL_PROGRAM_POINT_SIZE, 0, glEnable(GL_PROGRAM_POINT_SIZE))                                        \
    X(get, GL_RASTERIZER_DISCARD, 0, glEnable(GL_RASTERIZER_DISCARD))                                        \
    X(get, GL_SAMPLE_ALPHA_TO_COVERAGE, 0, glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE))                            \
    X(get, GL_SAMPLE_ALPHA_TO_ONE, 0, glEnable(GL_SAMPLE_ALPHA_TO_ONE))                                      \
    X(get, GL_SAMPLE_COVERAGE, 0, glEnable(GL_SAMPLE_COVERAGE))                                              \
    X(get, GL_SAMPLE_MASK, 0, glEnable(GL_SAMPLE_MASK))                                                      \
    X(get, GL_SAMPLE_SHADING, 0, glEnable(GL_SAMPLE_SHADING))                                                \
    X(get, GL_SCISSOR_TEST, 0, glEnable(GL_SCISSOR_TEST))                                                    \
    X(enabled, GL_SCISSOR_TEST, 3, glEnablei(GL_SCISSOR_TEST, 3))                                            \
    X(get, GL_STENCIL_TEST, 0, glEnable(GL_STENCIL_TEST))                                                    \
    X(get, GL_TEXTURE_CUBE_MAP_SEAMLESS, 0, glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS))

#define STATES_OF_PIXELS(X)                                                                                  \
    X(get, GL_PACK_SWAP_BYTES, 0, glPixelStorei(GL_PACK_SWAP_BYTES, 1))                                      \
    X(get, GL_PACK_LSB_FIRST, 0, glPixelStorei(GL_PACK_LSB_FIRST, 1))                                        \
    X(get, GL_PACK_ROW_LENGTH, 0, glPixelStorei(GL_PACK_ROW_LENGTH, 4000))                                   \
    X(get, GL_PACK_IMAGE_HEIGHT, 0, glPixelStorei(GL_PACK_IMAGE_HEIGHT, 4000))                               \
    X(get, GL_PACK_SKIP_ROWS, 0, glPixelStorei(GL_PACK_SKIP_ROWS, 400))                                      \
    X(get, GL_PACK_SKIP_PIXELS, 0, glPixelStorei(GL_PACK_SKIP_PIXELS, 4000))                                 \
    X(get, GL_PACK_SKIP_IMAGES, 0, glPixelStorei(GL_PACK_SKIP_IMAGES, 4))                                    \
    X(get, GL_PACK_ALIGNMENT, 0, glPixelStorei(GL_PACK_ALIGNMENT, 1))                                        \
    X(get, GL_UNPACK_SWAP_BYTES, 0, glPixelStorei(GL_UNPACK_SWAP_BYTES, 1))                                  \
    X(get, GL_UNPACK_LSB_FIRST, 0, glPixelStorei(GL_UNPACK_LSB_FIRST, 1))                                    \
    X(get, GL_UNPACK_ROW_LENGTH, 0, glPixelStorei(GL_UNPACK_ROW_LENGTH, 4000))                               \
    X(get, GL_UNPACK_IMAGE_HEIGHT, 0, glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 4000))                           \
    X(get, GL_UNPACK_SKIP_ROWS, 0, glPixelStorei(GL_UNPACK_SKIP_ROWS, 400))                                  \
    X(get, GL_UNPACK_SKIP_PIXELS, 0, glPixelStorei(GL_UNPACK_SKIP_PIXELS, 4000))                             \
    X(get, GL_UNPACK_SKIP_IMAGES, 0, glPixelStorei(GL_UNPACK_SKIP_IMAGES, 4))                                \
    X(get, GL_UNPACK_ALIGNMENT, 0, glPixelStorei(GL_UNPACK_ALIGNMENT, 1))                                    \
    X(get, GL_CLAMP_READ_COLOR, 0, glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE))

#define STATES_OF_GEOMETRY(X)                                                                                \
    X(attribute, GL_CURRENT_VERTEX_ATTRIB, 1, glVertexAttrib4f(1, 5, 6, 7, 8))                               \
    X(get, GL_PATCH_VERTICES, 0, glPatchParameteri(GL_PATCH_VERTICES, 4))                                    \
    X(get, GL_PATCH_DEFAULT_OUTER_LEVEL, 0,                                                                  \
      glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, (float[]){2, 3, 4, 5}))                               \
    X(get, GL_PATCH_DEFAULT_INNER_LEVEL, 0,                                                                  \
      glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, (float[]){2, 3}))                                     \
    X(get, GL_PRIMITIVE_RESTART_INDEX, 0, glPrimitiveRestartIndex(7))                                        \
    X(get, GL_PROVOKING_VERTEX, 0, glProvokingVertex(GL_FIRST_VERTEX_CONVENTION))                            \
    X(get, GL_VIEWPORT, 0, glViewport(1, 2, 3, 4))                                                           \
    X(range, GL_VIEWPORT, 2, glViewportIndexedf(2, 1, 2, 3, 4))                                              \
    X(get, GL_SCISSOR_BOX, 0, glScissor(1, 2, 3, 4))                                                         \
    X(indexed, GL_SCISSOR_BOX, 2, glScissorIndexed(2, 1, 2, 3, 4))                                           \
    X(get, GL_DEPTH_RANGE, 0, glDepthRange(0.75, 0.25))                                                      \
    X(range, GL_DEPTH_RANGE, 2, glDepthRangeIndexed(2, 0.75, 0.25))

#define STATES_OF_RASTERIZER(X)                                                                              \
    X(get, GL_CULL_FACE_MODE, 0, glCullFace(GL_FRONT_AND_BACK))                                              \
    X(get, GL_FRONT_FACE, 0, glFrontFace(GL_CW))                                                             \
    X(get, GL_POLYGON_MODE, 0, glPolygonMode(GL_FRONT_AND_BACK, GL_LINE))                                    \
    X(get, GL_POLYGON_OFFSET_FACTOR, 0, glPolygonOffset(9, 0))                                               \
    X(get, GL_POLYGON_OFFSET_UNITS, 0, glPolygonOffset(0, 9))                                                \
    X(get, GL_LINE_WIDTH, 0, glLineWidth(3))                                                                 \
    X(get, GL_POINT_SIZE, 0, glPointSize(9))                                                                 \
    X(get, GL_POINT_FADE_THRESHOLD_SIZE, 0, glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 9))              \
    X(get, GL_POINT_SPRITE_COORD_ORIGIN, 0, glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT))  \
    X(get, GL_SAMPLE_COVERAGE_VALUE, 0, glSampleCoverage(0, GL_FALSE))                                       \
    X(get, GL_SAMPLE_COVERAGE_INVERT, 0, glSampleCoverage(1, GL_TRUE))                                       \
    X(get, GL_MIN_SAMPLE_SHADING_VALUE, 0, glMinSampleShading(1))                                            \
    X(indexed, GL_SAMPLE_MASK_VALUE, 0, glSampleMaski(0, 0))                                                 \
    X(get, GL_FRAGMENT_SHADER_DERIVATIVE_HINT, 0, glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, GL_FASTEST))    \
    X(get, GL_LINE_SMOOTH_HINT, 0, glHint(GL_LINE_SMOOTH_HINT, GL_FASTEST))                                  \
    X(get, GL_POLYGON_SMOOTH_HINT, 0, glHint(GL_POLYGON_SMOOTH_HINT, GL_FASTEST))                            \
    X(get, GL_TEXTURE_COMPRESSION_HINT, 0, glHint(GL_TEXTURE_COMPRESSION_HINT, GL_FASTEST))

#define STATES_OF_FRAGMENTS(X)                                                                               \
    X(get, GL_DEPTH_FUNC, 0, glDepthFunc(GL_NEVER))                                                          \
    X(get, GL_DEPTH_WRITEMASK, 0, glDepthMask(GL_FALSE))                                                     \
    X(get, GL_COLOR_WRITEMASK, 0, glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE))                        \
    X(indexed, GL_COLOR_WRITEMASK, 1, glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE))               \
    X(get, GL_STENCIL_WRITEMASK, 0, glStencilMaskSeparate(GL_FRONT, 0))                                      \
    X(get, GL_STENCIL_BACK_WRITEMASK, 0, glStencilMaskSeparate(GL_BACK, 0))                                  \
    X(get, GL_STENCIL_FUNC, 0, glStencilFuncSeparate(GL_FRONT, GL_NEVER, 0, ~0u))                            \
    X(get, GL_STENCIL_BACK_REF, 0, glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 3, ~0u))                        \
    X(get, GL_STENCIL_VALUE_MASK, 0, glStencilFuncSeparate(GL_FRONT, GL_ALWAYS, 0, 1))                       \
    X(get, GL_STENCIL_FAIL, 0, glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_KEEP, GL_KEEP))                   \
    X(get, GL_STENCIL_BACK_PASS_DEPTH_FAIL, 0, glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR, GL_KEEP))      \
    X(get, GL_STENCIL_PASS_DEPTH_PASS, 0, glStencilOp(GL_KEEP, GL_KEEP, GL_INCR))                            \
    X(get, GL_BLEND_SRC_RGB, 0, glBlendFuncSeparate(GL_ZERO, GL_ZERO, GL_ONE, GL_ZERO))                      \
    X(get, GL_BLEND_DST_ALPHA, 0, glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ONE))                      \
    X(indexed, GL_BLEND_SRC_RGB, 1, glBlendFunci(1, GL_ZERO, GL_ONE))                                        \
    X(get, GL_BLEND_EQUATION_RGB, 0, glBlendEquationSeparate(GL_MIN, GL_FUNC_ADD))                           \
    X(indexed, GL_BLEND_EQUATION_ALPHA, 1, glBlendEquationi(1, GL_MAX))                                      \
    X(get, GL_BLEND_COLOR, 0, glBlendColor(1, 0.5f, 0, 1))                                                   \
    X(get, GL_LOGIC_OP_MODE, 0, glLogicOp(GL_CLEAR))                                                         \
    X(get, GL_COLOR_CLEAR_VALUE, 0, glClearColor(1, 0, 1, 0))                                                \
    X(get, GL_DEPTH_CLEAR_VALUE, 0, glClearDepth(0))                                                         \
    X(get, GL_STENCIL_CLEAR_VALUE, 0, glClearStencil(7))

#define STATES_OF_BINDINGS(X)                                                                                \
    X(get, GL_ACTIVE_TEXTURE, 0, glActiveTexture(GL_TEXTURE5))                                               \
    X(unit, GL_TEXTURE_BINDING_1D, 1, bind_texture(GL_TEXTURE_1D, 1))                                        \
    X(unit, GL_TEXTURE_BINDING_2D, 0, bind_texture(GL_TEXTURE_2D, 0))                                        \
    X(unit, GL_TEXTURE_BINDING_2D, 31, bind_texture(GL_TEXTURE_2D, 31))                                      \
    X(unit, GL_TEXTURE_BINDING_3D, 2, bind_texture(GL_TEXTURE_3D, 2))                                        \
    X(unit, GL_TEXTURE_BINDING_1D_ARRAY, 0, bind_texture(GL_TEXTURE_1D_ARRAY, 0))                            \
    X(unit, GL_TEXTURE_BINDING_2D_ARRAY, 0, bind_texture(GL_TEXTURE_2D_ARRAY, 0))                            \
    X(unit, GL_TEXTURE_BINDING_RECTANGLE, 0, bind_texture(GL_TEXTURE_RECTANGLE, 0))                          \
    X(unit, GL_TEXTURE_BINDING_CUBE_MAP, 9, bind_texture(GL_TEXTURE_CUBE_MAP, 9))                            \
    X(unit, GL_TEXTURE_BINDING_BUFFER, 0, bind_texture(GL_TEXTURE_BUFFER, 0))                                \
    X(unit, GL_TEXTURE_BINDING_2D_MULTISAMPLE, 0, bind_texture(GL_TEXTURE_2D_MULTISAMPLE, 0))                \
    X(unit, GL_SAMPLER_BINDING, 0, bind_sampler(0))                                                          \
    X(unit, GL_SAMPLER_BINDING, 20, bind_sampler(20))                                                        \
    X(get, GL_ARRAY_BUFFER_BINDING, 0, bind_buffer(GL_ARRAY_BUFFER))                                         \
    X(get, GL_PIXEL_PACK_BUFFER_BINDING, 0, bind_buffer(GL_PIXEL_PACK_BUFFER))                               \
    X(get, GL_PIXEL_UNPACK_BUFFER_BINDING, 0, bind_buffer(GL_PIXEL_UNPACK_BUFFER))                           \
    X(get, GL_COPY_READ_BUFFER, 0, bind_buffer(GL_COPY_READ_BUFFER))                                         \
    X(get, GL_COPY_WRITE_BUFFER, 0, bind_buffer(GL_COPY_WRITE_BUFFER))                                       \
    X(get, GL_DRAW_INDIRECT_BUFFER_BINDING, 0, bind_buffer(GL_DRAW_INDIRECT_BUFFER))                         \
    X(get, GL_UNIFORM_BUFFER_BINDING, 0, bind_buffer(GL_UNIFORM_BUFFER))                                     \
    X(indexed, GL_UNIFORM_BUFFER_BINDING, 2, bind_buffer_base(GL_UNIFORM_BUFFER, 2))                         \
    X(indexed, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1, bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 1))   \
    X(get, GL_DRAW_FRAMEBUFFER_BINDING, 0, bind_framebuffer(GL_DRAW_FRAMEBUFFER))                            \
    X(get, GL_READ_FRAMEBUFFER_BINDING, 0, bind_framebuffer(GL_READ_FRAMEBUFFER))                            \
    X(get, GL_RENDERBUFFER_BINDING, 0, bind_renderbuffer())                                                  \
    X(get, GL_VERTEX_ARRAY_BINDING, 0, bind_vertex_array())                                                  \
    X(get, GL_CURRENT_PROGRAM, 0, glUseProgram(feedback_program()))                                          \
    X(get, GL_PROGRAM_PIPELINE_BINDING, 0, bind_pipeline())                                                  \
    X(get, GL_DRAW_BUFFER, 0, glDrawBuffer(GL_NONE))                                                         \
    X(get, GL_READ_BUFFER, 0, glReadBuffer(GL_NONE))

#define STATES_OF_WHAT_RUNS(X)                                                                               \
    X(query, GL_SAMPLES_PASSED, 0, begin_query(GL_SAMPLES_PASSED, 0))                                        \
    X(query, GL_ANY_SAMPLES_PASSED, 0, begin_query(GL_ANY_SAMPLES_PASSED, 0))                                \
    X(query, GL_TIME_ELAPSED, 0, begin_query(GL_TIME_ELAPSED, 0))                                            \
    X(query, GL_PRIMITIVES_GENERATED, 0, begin_query(GL_PRIMITIVES_GENERATED, 0))                            \
    X(query, GL_PRIMITIVES_GENERATED, 2, begin_query(GL_PRIMITIVES_GENERATED, 2))                            \
    X(query, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0,                                                    \
      begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0))                                              \
    X(get, GL_TRANSFORM_FEEDBACK_BINDING, 0, bind_feedback())                                                \
    X(get, GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, 0, begin_feedback())                                         \
    X(get, GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, 0, (begin_feedback(), glPauseTransformFeedback()))           \
    X(condition, GL_QUERY_WAIT, 0, begin_condition())

#define STATES(X)                                                                                            \
    STATES_OF_SWITCHES(X)                                                                                    \
    STATES_OF_PIXELS(X)                                                                                      \
    STATES_OF_GEOMETRY(X)                                                                                    \
    STATES_OF_RASTERIZER(X)                                                                                  \
    STATES_OF_FRAGMENTS(X)                                                                                   \
    STATES_OF_BINDINGS(X)                                                                                    \
    STATES_OF_WHAT_RUNS(X)
