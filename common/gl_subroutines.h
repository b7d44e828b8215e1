// A call that OpenGL allows and Mesa does not survive.
#pragma once

#include <glad/gl.h>

// After gladLoadGL: lets glUniformSubroutinesuiv do nothing where the stage has no subroutine uniform and the
// lab says so (count 0). OpenGL 4.1 core, 2.11.7 allows it; Mesa 22.3 reads its list of uniforms before it
// looks at the count.
void gl_subroutines_guard(void);
