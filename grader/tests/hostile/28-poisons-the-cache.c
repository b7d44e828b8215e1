// What the next process might find.
// must: drawn
static void attack(const Frame *frame) {
    (void)frame;
    DENIED(opens(ROOT "/build/cache/shaders/shadow-lab-hostile", O_WRONLY | O_CREAT));
    DENIED(opens(ROOT "/build/shadow-lab-hostile", O_WRONLY | O_CREAT));
    DENIED(opens(ROOT "/build/worker", O_RDWR));
    DENIED(getenv("HOME") || getenv("PATH") || getenv("USER"));
    setenv("LIBGL_ALWAYS_SOFTWARE", "0", 1);
    setenv("MESA_GL_VERSION_OVERRIDE", "1.0", 1);
}
