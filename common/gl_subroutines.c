#include "gl_subroutines.h"

static PFNGLUNIFORMSUBROUTINESUIVPROC of_driver;

static void GLAD_API_PTR choose(GLenum stage, GLsizei count, const GLuint *indices) {
    GLint program = 0, locations = 1;
    glad_glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    if (count == 0 && program != 0)
        glad_glGetProgramStageiv((GLuint)program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &locations);
    if (locations > 0)
        of_driver(stage, count, indices);
}

void gl_subroutines_guard(void) {
    if (glad_glUniformSubroutinesuiv != choose)
        of_driver = glad_glUniformSubroutinesuiv;
    glad_glUniformSubroutinesuiv = choose;
}
