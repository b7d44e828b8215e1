// A long loop in a shader, drawn again and again.
// must: timeout
static void attack(const Frame *frame) {
    for (;;) {
        draw_fullscreen(&frame->programs[0]);
        glFinish();
    }
}
